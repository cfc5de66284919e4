// item_pass_test.cpp - compares items drawn by OpenGL with those of the cpu engine.
#include "gl/items/item_pass.h"

#include "gl/items/item_readback.h"
#include "gl_context.h"
#include "items.h"
#include "message_of.h"
#include "scene/model/borrow.h"
#include "scenes.h"

#include <random>

namespace firsthit {
namespace {

using ItemPass = test::OnContext;

constexpr int kSize = 512;

/// Snapped corners move edges by 1/256 of a pixel: few pixels change, at borders only.
constexpr double kWrongShare = 0.003;

View view_of(const World& world)
{
    return {world.camera, kSize, kSize, {0, 0, kSize, kSize}};
}

struct Formats {
    ItemFormat item = ItemFormat::r32ui;
    DepthFormat depth = DepthFormat::float32;
};

/// Draws the world and reads it back in `chunks`; 0: at once.
std::vector<std::uint32_t> draw(const gl::Context& context, const World& world, const View& view,
    const Formats& formats, int chunks = 0)
{
    Tasks tasks(1);
    const test::EyeWorld eye(world, view);
    const Pencil& pencil = eye.memory.pencil;
    gl::SceneBuffers scene(context, gl::Detail::items);
    scene.pose(world, pencil);
    gl::DepthRange range;
    if (formats.depth == DepthFormat::fixed24)
        range = gl::fit_depth(eye.memory.corner.span(), world.scene->index, pencil, tasks);
    gl::ItemPass pass(context);
    pass.draw(scene, pencil, formats.item, formats.depth, range);
    gl::ItemReadback readback(context);
    readback.start(pass, chunks > 0 ? Readback::async : Readback::sync, chunks);
    while (readback.rows_ready() < readback.height()) readback.wait();
    return {readback.picture().begin(), readback.picture().end()};
}

/// The share of the samples whose items differ from the cpu engine's.
double wrong_share(
    const gl::Context& context, const World& world, const View& view, const Formats& formats)
{
    const std::vector<std::uint32_t> expected = test::items_of(world, view);
    const std::vector<std::uint32_t> found = draw(context, world, view, formats);
    EXPECT_EQ(found.size(), expected.size());
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) wrong += found[i] != expected[i];
    return double(wrong) / double(expected.size());
}

class ItemFormats : public test::OnContext, public testing::WithParamInterface<Formats> {
  protected:
    void expect_scene(const std::string& name, double time)
    {
        const Scene scene = load_scene(name);
        World world;
        pose(borrow(scene), time, world);
        EXPECT_LT(wrong_share(*context, world, view_of(world), GetParam()), kWrongShare);
    }
};

TEST_P(ItemFormats, ShowTheTorusAsTheCpuDoes)
{
    expect_scene("builtin:torus", 0);
}

TEST_P(ItemFormats, ShowTheRobotsAsTheCpuDoes)
{
    expect_scene("builtin:robots", 2.5);
}

TEST_P(ItemFormats, ShowAWaveOf100000TrianglesAsTheCpuDoes)
{
    expect_scene("builtin:wave?n=100000", 0.5);
}

std::string name_of(const testing::TestParamInfo<Formats>& info)
{
    const char* const items[] = {"r32ui", "rgb8", "rgba8"};
    const char* const depths[] = {"float32", "fixed24"};
    return std::string(items[int(info.param.item)]) + "_" + depths[int(info.param.depth)];
}

INSTANTIATE_TEST_SUITE_P(All, ItemFormats,
    testing::Values(Formats{ItemFormat::r32ui, DepthFormat::float32},
        Formats{ItemFormat::r32ui, DepthFormat::fixed24},
        Formats{ItemFormat::rgb8, DepthFormat::float32},
        Formats{ItemFormat::rgb8, DepthFormat::fixed24},
        Formats{ItemFormat::rgba8, DepthFormat::float32},
        Formats{ItemFormat::rgba8, DepthFormat::fixed24}),
    name_of);

/// A hand-made world that a straight camera of kSize x kSize sees.
double wrong_share(
    const gl::Context& context, test::TestWorld& made, DepthFormat depth = DepthFormat::float32)
{
    const View view = test::straight_view(kSize, kSize, kSize);
    return wrong_share(context, made.finish(), view, {ItemFormat::r32ui, depth});
}

TEST_F(ItemPass, DrawsTrianglesThroughTheEyePlane)
{
    test::TestWorld made;
    made.add({-5, 1, -3}, {5, 1, -3}, {0, 1, 40});    // a floor that begins behind the eye
    made.add({-5, -1, 30}, {5, -2, 30}, {0, -1, -9}); // a ceiling that ends there
    made.add({-1, -9, -2}, {-1, 9, -2}, {-3, 0, 20});
    EXPECT_LT(wrong_share(*context, made), kWrongShare);
}

TEST_F(ItemPass, DrawsSmallTrianglesAroundAndBehindTheEye)
{
    test::TestWorld made;
    std::mt19937 random(5);
    std::uniform_real_distribution<float> at(-1, 1), size(-0.02f, 0.02f);
    for (int k = 0; k < 3000; ++k) {
        const glm::vec3 a{at(random), at(random), at(random)};
        const auto near_a = [&] { return a + glm::vec3(size(random), size(random), size(random)); };
        const glm::vec3 b = near_a(), c = near_a();
        made.add(a, b, c);
    }
    EXPECT_LT(wrong_share(*context, made), kWrongShare);
}

TEST_F(ItemPass, DrawsWhatIsExtremelyNearAndFar)
{
    test::TestWorld made;
    made.add({-1e-7f, -1e-7f, 1e-7f}, {1e-7f, -1e-7f, 1e-7f}, {0, 0, 1e-7f});
    made.add({-1e8f, -1e8f, 1e8f}, {1e8f, -1e8f, 1e8f}, {0, 1e8f, 1e8f});
    EXPECT_LT(wrong_share(*context, made), kWrongShare);
}

TEST_F(ItemPass, KeepsTheOrderOfCloseSurfaces)
{
    // A thousandth of a unit apart, a thousand units away.
    test::TestWorld made;
    made.add({-900, -900, 1000.01f}, {900, -900, 1000.01f}, {0, 900, 1000.01f});
    made.add({-900, -900, 1000}, {900, -900, 1000}, {0, 900, 1000});
    made.add({-0.001f, 0.5f, 1}, {0.001f, 0.5f, 1}, {0, 0.6f, 1}); // the eye is not far
    EXPECT_LT(wrong_share(*context, made), kWrongShare);
}

TEST_F(ItemPass, GivesTheLowerNumberWhereTrianglesCoincide)
{
    test::TestWorld made;
    for (int k = 0; k < 3; ++k) made.add({-2, -2, 4}, {2, -2, 4}, {0, 2, 5});
    for (const DepthFormat depth : {DepthFormat::float32, DepthFormat::fixed24})
        EXPECT_LT(wrong_share(*context, made, depth), kWrongShare);
}

TEST_F(ItemPass, DrawsRegionsOfAPictureAsTheWhole)
{
    const Scene scene = load_scene("builtin:torus");
    World world;
    pose(borrow(scene), 0, world);
    View view = view_of(world);
    const std::vector<std::uint32_t> whole = draw(*context, world, view, {});
    view.region = {130, 97, 301, 211};
    const std::vector<std::uint32_t> region = draw(*context, world, view, {});
    std::size_t different = 0;
    for (int y = 0; y < view.region.height; ++y)
        for (int x = 0; x < view.region.width; ++x)
            different += region[std::size_t(y * view.region.width + x)] !=
                         whole[std::size_t((y + view.region.y) * kSize + x + view.region.x)];
    // Corners have other coordinates before they are snapped.
    EXPECT_LT(double(different), kWrongShare * double(region.size()));
}

TEST_F(ItemPass, ChunksAreTheWholePicture)
{
    const Scene scene = load_scene("builtin:robots");
    World world;
    pose(borrow(scene), 2.5, world);
    View view = view_of(world);
    view.region = {3, 5, 257, 131}; // no multiple of anything
    const std::vector<std::uint32_t> whole = draw(*context, world, view, {});
    for (const int chunks : {1, 2, 7, 64, 1000})
        EXPECT_EQ(draw(*context, world, view, {}, chunks), whole) << chunks << " chunks";
    for (const ItemFormat format : {ItemFormat::rgb8, ItemFormat::rgba8})
        EXPECT_EQ(draw(*context, world, view, {format, DepthFormat::float32}, 5), whole);
}

TEST_F(ItemPass, TwoDrawsGiveTheSamePicture)
{
    const Scene scene = load_scene("builtin:robots");
    World world;
    pose(borrow(scene), 2.5, world);
    EXPECT_EQ(draw(*context, world, view_of(world), {}), draw(*context, world, view_of(world), {}));
}

TEST(ItemCoding, HoldsNumbersUpToItsLimit)
{
    EXPECT_EQ(gl::most_triangles(ItemFormat::rgb8), 16777215u);
    EXPECT_EQ(gl::most_triangles(ItemFormat::rgba8), 4294967295u);
    EXPECT_EQ(gl::most_triangles(ItemFormat::r32ui), 4294967295u);
    // Alpha of rgb8 is read as 255.
    EXPECT_EQ(gl::decoded(ItemFormat::rgb8, 0xFFFFFFFEu), 0xFFFFFEu);
    EXPECT_EQ(gl::decoded(ItemFormat::rgb8, 0xFFFFFFFFu), kNoItem);
    EXPECT_EQ(gl::decoded(ItemFormat::rgb8, 0xFF000000u), 0u);
    EXPECT_EQ(gl::decoded(ItemFormat::rgba8, 0xFFFFFFFEu), 0xFFFFFFFEu);
    EXPECT_EQ(gl::decoded(ItemFormat::rgba8, 0xFFFFFFFFu), kNoItem);
}

TEST(ItemCoding, MoreTrianglesThanItHoldsAreAnErrorWithNumbers)
{
    EXPECT_NO_THROW(gl::check_triangles(ItemFormat::rgb8, 16777215));
    EXPECT_EQ(message_of<ArgumentError>([] { gl::check_triangles(ItemFormat::rgb8, 16777216); }),
        "16777216 triangles are too many for the item format rgb8: it holds 16777215");
    EXPECT_NO_THROW(gl::check_triangles(ItemFormat::rgba8, 4294967295));
    EXPECT_THROW(gl::check_triangles(ItemFormat::rgba8, 4294967296), ArgumentError);
}

TEST_F(ItemPass, PencilsThatItCannotDrawAreErrors)
{
    test::TestWorld empty;
    empty.finish();
    gl::SceneBuffers scene(*context, gl::Detail::items);
    scene.pose(empty.world, Pencil{});
    gl::ItemPass pass(*context);
    const auto message = [&](const Pencil& pencil) {
        try {
            pass.draw(scene, pencil, ItemFormat::r32ui, DepthFormat::float32);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    Pencil parallel;
    parallel.width = parallel.height = 8;
    parallel.parallel = true;
    EXPECT_EQ(message(parallel), "items are drawn for rays through an eye only");
    Pencil wide;
    wide.width = context->info().max_texture_size + 1;
    wide.height = 1;
    EXPECT_NE(message(wide).find(std::to_string(wide.width) + "x1 samples"), std::string::npos)
        << message(wide);
}

TEST(FitDepth, HoldsWhatTheRaysSeeAndNoMore)
{
    test::TestWorld made;
    made.add({-1, -1, 4}, {1, -1, 4}, {0, 1, 6});
    made.add({50, 0, 1}, {51, 0, 1}, {50, 1, 1});       // beside the picture
    made.add({0, 0, -7}, {1, 0, -7}, {0, 1, -7});       // behind the eye
    made.add({-90, 0, 9}, {90, 0.5f, 9}, {0, 300, 90}); // leaves the picture at 10.4
    const View view = test::straight_view(64, 64, 64);
    const test::EyeWorld eye(made.finish(), view);
    Tasks tasks(2);
    const gl::DepthRange range =
        gl::fit_depth(eye.memory.corner.span(), made.scene->index, eye.memory.pencil, tasks);
    EXPECT_NEAR(range.near, 4, 0.01);
    EXPECT_GT(range.near, 3.99);
    EXPECT_LT(range.far, 11);
    EXPECT_GT(range.far, 10);
}

TEST(FitDepth, KeepsARatioForWhatPassesTheEye)
{
    test::TestWorld made;
    made.add({-5, 1, -3}, {5, 1, -3}, {0, 0, 40});
    made.add({-1, -1, 1e-6f}, {1, -1, 1e-6f}, {0, 1, 1e-6f});
    const test::EyeWorld eye(made.finish(), test::straight_view(64, 64, 64));
    Tasks tasks(1);
    const gl::DepthRange range =
        gl::fit_depth(eye.memory.corner.span(), made.scene->index, eye.memory.pencil, tasks);
    EXPECT_GT(range.near, 0);
    EXPECT_NEAR(range.far / range.near, gl::kMostDepths, 1);
}

TEST(FitDepth, OfAnEmptySceneIsAValidRange)
{
    Tasks tasks(1);
    const gl::DepthRange range = gl::fit_depth({}, {}, Pencil{}, tasks);
    EXPECT_LT(0, range.near);
    EXPECT_LT(range.near, range.far);
}

} // namespace
} // namespace firsthit
