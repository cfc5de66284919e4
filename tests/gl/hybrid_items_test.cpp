// hybrid_items_test.cpp - frames of the CPU with items that OpenGL drew.
#include "gl/items/hybrid_items.h"

#include "cpu/frame.h"
#include "gl_context.h"
#include "items.h"
#include "message_of.h"
#include "scene/model/borrow.h"
#include "scenes.h"

namespace firsthit {
namespace {

/// A context that is not current, and the objects of the hybrid engine on it.
class Hybrid : public test::OnContext {
  protected:
    void SetUp() override
    {
        test::OnContext::SetUp();
        if (!context) return;
        scene_buffers = std::make_unique<gl::SceneBuffers>(*context, gl::Detail::items);
        current.reset();
        items = std::make_unique<gl::HybridItems>(*context, *scene_buffers);
    }

    void TearDown() override
    {
        items.reset();
        if (context) current = std::make_unique<gl::Current>(*context);
        scene_buffers.reset();
        test::OnContext::TearDown();
    }

    /// The items that the source makes for a frame.
    std::vector<std::uint32_t> render(
        const World& world, const View& view, const Settings& wanted, int threads = 2)
    {
        Settings settings = wanted;
        settings.color = false;
        settings.aovs = {Aov::item};
        items->set(settings);
        Tasks tasks(threads);
        Film film;
        Stats stats;
        const View filled = checked(view);
        render_frame({world, filled, tasks, film}, settings, memory, stats, {items.get()});
        return film.item;
    }

    std::unique_ptr<gl::SceneBuffers> scene_buffers;
    std::unique_ptr<gl::HybridItems> items;
    FrameMemory memory;
};

Settings with(Multisample multisample, Readback readback, int chunks = 8)
{
    Settings settings;
    settings.multisample = multisample;
    settings.interpolate = false;
    settings.opengl.readback = readback;
    settings.opengl.readback_chunks = chunks;
    return settings;
}

View view_of(const World& world, int size)
{
    View view;
    view.camera = world.camera;
    view.width = view.height = size;
    return view;
}

std::size_t differing(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b)
{
    EXPECT_EQ(a.size(), b.size());
    std::size_t count = 0;
    for (std::size_t k = 0; k < a.size(); ++k) count += a[k] != b[k];
    return count;
}

TEST_F(Hybrid, RepairedItemsAreNearlyTheCpuEngines)
{
    const Scene scene = load_scene("builtin:robots");
    World world;
    pose(borrow(scene), 2.5, world);
    const View view = view_of(world, 512);
    const std::vector<std::uint32_t> expected = test::items_of(world, view, 2);
    const std::size_t none =
        differing(render(world, view, with(Multisample::none, Readback::async)), expected);
    const std::size_t lazy =
        differing(render(world, view, with(Multisample::lazy3, Readback::async)), expected);
    EXPECT_LT(double(none), 0.003 * double(expected.size()));
    EXPECT_LT(lazy, none);
}

TEST_F(Hybrid, ChunksAndTransfersGiveTheSameItems)
{
    const Scene scene = load_scene("builtin:robots");
    World world;
    pose(borrow(scene), 2.5, world);
    const View view = view_of(world, 333);
    for (const Multisample mode : {Multisample::none, Multisample::lazy5, Multisample::full3}) {
        const auto whole = render(world, view, with(mode, Readback::sync));
        for (const int chunks : {1, 2, 5, 64})
            EXPECT_EQ(render(world, view, with(mode, Readback::async, chunks)), whole)
                << chunks << " chunks";
    }
}

TEST_F(Hybrid, FormatsGiveTheSameItems)
{
    const Scene scene = load_scene("builtin:torus");
    World world;
    pose(borrow(scene), 0, world);
    const View view = view_of(world, 200);
    Settings settings = with(Multisample::lazy3, Readback::async);
    const auto expected = render(world, view, settings);
    for (const ItemFormat format : {ItemFormat::rgb8, ItemFormat::rgba8}) {
        settings.opengl.item_format = format;
        EXPECT_EQ(render(world, view, settings), expected);
    }
    settings.opengl.depth_format = DepthFormat::fixed24;
    const auto fixed = render(world, view, settings);
    EXPECT_LT(double(differing(fixed, expected)), 0.003 * double(expected.size()));
}

TEST_F(Hybrid, RegionsAreDrawnAsPicturesOfTheirOwn)
{
    const Scene scene = load_scene("builtin:torus");
    World world;
    pose(borrow(scene), 0, world);
    View view = view_of(world, 300);
    view.region = {20, 35, 211, 133};
    const Settings settings = with(Multisample::lazy3, Readback::async);
    const auto expected = test::items_of(world, view);
    EXPECT_LT(double(differing(render(world, view, settings), expected)),
        0.003 * double(expected.size()));
}

TEST_F(Hybrid, FollowsTheSceneFromFrameToFrame)
{
    const Scene scene = load_scene("builtin:wave?n=5000");
    World world;
    for (const double time : {0.0, 0.4, 0.8}) {
        pose(borrow(scene), time, world);
        const View view = view_of(world, 128);
        const auto expected = test::items_of(world, view);
        EXPECT_LT(double(differing(
                      render(world, view, with(Multisample::lazy3, Readback::async)), expected)),
            0.003 * double(expected.size()))
            << time << " s";
    }
}

TEST_F(Hybrid, AnEmptySceneHasNoItems)
{
    test::TestWorld empty;
    const auto found = render(
        empty.finish(), test::straight_view(64, 64, 64), with(Multisample::full5, Readback::async));
    EXPECT_EQ(found, std::vector<std::uint32_t>(64 * 64, kNoItem));
}

TEST_F(Hybrid, ErrorsOfTheDriversThreadArriveAndTheNextFrameWorks)
{
    Scene vast;
    vast.vertices = std::size_t(context->info().max_storage_bytes) / 16 + 1;
    World world;
    world.scene = borrow(vast);
    View view = test::straight_view(64, 64, 64);
    for (const Readback readback : {Readback::async, Readback::sync}) {
        const std::string message = message_of<DeviceError>(
            [&] { render(world, view, with(Multisample::none, readback)); });
        EXPECT_NE(message.find("vertices"), std::string::npos) << message;
    }
    test::TestWorld made;
    made.add({-9, -9, 4}, {9, -9, 4}, {0, 9, 4});
    EXPECT_EQ(
        render(made.finish(), view, with(Multisample::none, Readback::async))[32 * 64 + 32], 0u);
}

TEST_F(Hybrid, ManyFramesLeaveNoObjects)
{
    const Scene scene = load_scene("builtin:torus");
    World world;
    pose(borrow(scene), 0, world);
    const View view = view_of(world, 64);
    render(world, view, with(Multisample::lazy3, Readback::async));
    const std::int64_t alive = gl::gl_objects_alive();
    for (int frame = 0; frame < 200; ++frame) {
        world.camera.eye.x += 0.01; // posed again
        render(world, view_of(world, 64), with(Multisample::lazy3, Readback::async));
    }
    EXPECT_EQ(gl::gl_objects_alive(), alive);
}

} // namespace
} // namespace firsthit
