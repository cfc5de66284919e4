// renderer_test.cpp - pictures that must be equal, and settings that are refused.
#include "message_of.h"
#include "scene/model/borrow.h"
#include "scenes.h"

#include <firsthit/firsthit.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace firsthit::test {
namespace {

struct RenderedPicture {
    Scene scene = load_scene("builtin:robots");
    World world;
    View view;

    RenderedPicture()
    {
        pose(borrow(scene), 1.5, world);
        view.width = 96, view.height = 64;
        view.camera = world.camera;
    }

    Film render(const Settings& settings, int threads = 1) const
    {
        Renderer renderer(threads);
        Film film;
        renderer.render(world, view, settings, film);
        return film;
    }
};

void expect_equal(const Film& a, const Film& b)
{
    EXPECT_EQ(a.color.value, b.color.value);
    EXPECT_EQ(a.item, b.item);
    for (int k = 0; k < kAovCount; ++k) EXPECT_EQ(a[Aov(k)].value, b[Aov(k)].value);
}

Settings everything()
{
    Settings settings;
    for (int k = 0; k < kAovCount; ++k) settings.aovs.push_back(Aov(k));
    return settings;
}

TEST(Renderer, RefusesAWorldThatWasNeverPosed)
{
    Film film;
    EXPECT_THROW(Renderer(1).render(World{}, View{}, Settings{}, film), ArgumentError);
    std::vector<std::uint8_t> occluded;
    const std::vector<glm::vec3> point{{0, 0, 0}};
    EXPECT_THROW(Occlusion(1).test(World{}, point, Light{}, occluded), ArgumentError);
}

TEST(Renderer, MakesTheSameBitsWithAnyThreadsAndTiles)
{
    const RenderedPicture picture;
    Settings settings = everything();
    const Film expected = picture.render(settings);
    expect_equal(picture.render(settings, 2), expected);
    expect_equal(picture.render(settings, 5), expected);
    for (const int tile : {8, 40, 128}) {
        settings.tile_size = tile;
        expect_equal(picture.render(settings), expected);
    }
}

TEST(Renderer, MakesTheSamePlanesWithAnySamples)
{
    const RenderedPicture picture;
    Settings settings = everything();
    Film expected = picture.render(settings);
    settings.samples = 3;
    Film film = picture.render(settings, 2);
    EXPECT_NE(film.color.value, expected.color.value);
    film.color = expected.color;
    expect_equal(film, expected);
}

TEST(Renderer, AveragesASupersampledPicturesPixels)
{
    for (const int samples : {2, 3, 5}) {
        RenderedPicture picture;
        Settings settings;
        settings.samples = samples;
        const Film film = picture.render(settings);
        picture.view.width *= samples, picture.view.height *= samples;
        settings.samples = 1;
        const Film fine = picture.render(settings);
        for (int y = 0; y < film.height; ++y) {
            for (int x = 0; x < film.width * 3; ++x) {
                float sum = 0;
                for (int sy = 0; sy < samples; ++sy)
                    for (int sx = 0; sx < samples; ++sx)
                        sum += fine.color.value[std::size_t((y * samples + sy) * fine.width +
                                                            x / 3 * samples + sx) *
                                                    3 +
                                                std::size_t(x % 3)];
                EXPECT_NEAR(film.color.value[std::size_t(y * film.width * 3 + x)],
                    sum / float(samples * samples), 1e-6f);
            }
        }
    }
}

TEST(Renderer, MakesRegionsOfTheSamePicture)
{
    RenderedPicture picture;
    const Film whole = picture.render(everything());
    picture.view.region = {17, 5, 50, 33};
    const Film region = picture.render(everything(), 2);
    ASSERT_EQ(region.width, 50);
    ASSERT_EQ(region.height, 33);
    for (int y = 0; y < 33; ++y) {
        for (int x = 0; x < 50; ++x) {
            const auto from = std::size_t((y + 5) * 96 + x + 17), to = std::size_t(y * 50 + x);
            EXPECT_EQ(region.item[to], whole.item[from]);
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_EQ(region.color.value[3 * to + c], whole.color.value[3 * from + c]);
        }
    }
}

TEST(Renderer, FillsPlanesThatAgreeWithEachOther)
{
    const RenderedPicture picture;
    const Film film = picture.render(everything());
    int hits = 0;
    for (std::size_t i = 0; i < film.item.size(); ++i) {
        const float depth = film[Aov::depth].value[i], distance = film[Aov::distance].value[i];
        if (film.item[i] == kNoItem) {
            EXPECT_TRUE(std::isinf(depth) && std::isinf(distance));
            continue;
        }
        ++hits;
        const float* p = &film[Aov::position].value[3 * i];
        const glm::dvec3 from_eye = glm::dvec3(p[0], p[1], p[2]) - picture.view.camera.eye;
        EXPECT_NEAR(glm::length(from_eye) / double(distance), 1, 1e-5);
        EXPECT_NEAR(
            glm::dot(from_eye, glm::normalize(picture.view.camera.direction)) / double(depth), 1,
            1e-5);
        const float* n = &film[Aov::geometric_normal].value[3 * i];
        EXPECT_NEAR(glm::length(glm::vec3(n[0], n[1], n[2])), 1, 1e-5);
        EXPECT_LE(glm::dot(glm::dvec3(n[0], n[1], n[2]), from_eye), 1e-4 * double(distance));
    }
    EXPECT_GT(hits, 1000);
}

TEST(Renderer, CountsTheHitsInsideThePictureWhateverTheTileSize)
{
    RenderedPicture picture;
    picture.view.width = 97, picture.view.height = 43; // ends amid blocks
    Settings settings;
    settings.color = false;
    settings.aovs = {Aov::item};
    for (const int tile_size : {8, 64, 128}) {
        settings.tile_size = tile_size;
        Renderer renderer(1);
        Film film;
        renderer.render(picture.world, picture.view, settings, film);
        const auto none = std::count(film.item.begin(), film.item.end(), kNoItem);
        EXPECT_EQ(renderer.stats().hits, film.item.size() - std::size_t(none)) << tile_size;
    }
}

TEST(Renderer, ReusesAFilmForAnotherSize)
{
    RenderedPicture picture;
    Renderer renderer(1);
    Film film;
    renderer.render(picture.world, picture.view, everything(), film);
    picture.view.width = 31, picture.view.height = 200;
    Settings settings;
    renderer.render(picture.world, picture.view, settings, film);
    EXPECT_EQ(film.color.value.size(), 31u * 200 * 3);
    EXPECT_TRUE(film.item.empty());
    EXPECT_TRUE(film[Aov::depth].empty());
    expect_equal(film, picture.render(settings));
}

TEST(Renderer, DrawsAnEmptyWorldAsBackground)
{
    TestWorld world;
    world.scene->background = {0.25f, 0.5f, 1};
    world.finish();
    Renderer renderer(1);
    Film film;
    Settings settings;
    settings.aovs = {Aov::item};
    renderer.render(world.world, straight_view(9, 5, 9), settings, film);
    for (std::size_t i = 0; i < film.item.size(); ++i) {
        EXPECT_EQ(film.item[i], kNoItem);
        EXPECT_EQ(film.color.value[3 * i + 2], 1.0f);
    }
}

TEST(Renderer, FillsThePlaneOfEveryLightWithOneWhereNothingCastsShadows)
{
    RenderedPicture picture;
    picture.world.lights.resize(3);
    Settings settings = everything();
    settings.shadows = Shadows::none;
    const Film film = picture.render(settings, 2);
    const Plane& lit = film[Aov::lit];
    ASSERT_EQ(lit.channels, 3);
    ASSERT_EQ(lit.value.size(), film.item.size() * 3);
    std::size_t hits = 0;
    for (std::size_t i = 0; i < film.item.size(); ++i) {
        const float expected = film.item[i] == kNoItem ? 0.0f : 1.0f;
        hits += film.item[i] != kNoItem;
        for (std::size_t l = 0; l < 3; ++l) EXPECT_EQ(lit.value[3 * i + l], expected);
    }
    EXPECT_GT(hits, 1000u);
    EXPECT_LT(hits, film.item.size());
}

TEST(Renderer, RefusesThePlaneOfLightsWithoutAnyOrWithTooMany)
{
    RenderedPicture picture;
    Settings settings;
    settings.aovs = {Aov::lit};
    picture.world.lights.clear();
    EXPECT_EQ(message_of<ArgumentError>([&] { picture.render(settings); }),
        "the plane 'lit' has a channel for each light, and there is no light");
    picture.world.lights.resize(65);
    EXPECT_EQ(message_of<ArgumentError>([&] { picture.render(settings); }),
        "the plane 'lit' has a channel for each light, and 65 are too many: at most 64");
    settings.aovs = {};
    EXPECT_NO_THROW(picture.render(settings));
}

TEST(Renderer, RefusesAnInvalidLight)
{
    RenderedPicture picture;
    picture.world.lights[1].kind = Light::Kind::directional;
    picture.world.lights[1].direction = {0, 0, 0};
    const std::string message = message_of<SceneError>([&] { picture.render({}); });
    EXPECT_NE(message.find("light 1: its direction (0, 0, 0)"), std::string::npos) << message;
}

template <class Change>
void expect_refused(const char* part_of_message, const Change& change)
{
    TestWorld world;
    world.finish();
    View view = straight_view(8, 8, 8);
    Settings settings;
    change(view, settings);
    Renderer renderer(1);
    Film film;
    try {
        renderer.render(world.world, view, settings, film);
        FAIL() << "accepted: " << part_of_message;
    } catch (const ArgumentError& error) {
        EXPECT_NE(std::string(error.what()).find(part_of_message), std::string::npos)
            << error.what();
    }
}

TEST(Renderer, RefusesWhatCannotBeRendered)
{
    expect_refused("0x8", [](View& v, Settings&) { v.width = 0; });
    expect_refused("8x-1", [](View& v, Settings&) { v.height = -1; });
    expect_refused("100000x100000", [](View& v, Settings&) { v.width = v.height = 100000; });
    expect_refused("too many", [](View& v, Settings&) { v.width = v.height = 65536; });
    expect_refused("region", [](View& v, Settings&) { v.region = {4, 0, 8, 8}; });
    expect_refused("region", [](View& v, Settings&) { v.region = {-1, 0, 2, 2}; });
    expect_refused("region", [](View& v, Settings&) { v.region = {0, 0, 2147483647, 2147483647}; });
    const int least = std::numeric_limits<int>::min();
    expect_refused("region", [&](View& v, Settings&) { v.region = {least, least, 0, 0}; });
    expect_refused("samples", [](View&, Settings& s) { s.samples = 0; });
    expect_refused("samples", [](View&, Settings& s) { s.samples = 17; });
    for (const int every : {-1, 0, 3, 15, 17, 32})
        expect_refused(
            "accepted: 1, 2, 4, 8 or 16", [&](View&, Settings& s) { s.interleave = every; });
    expect_refused(
        "needs 1 sample, not 2", [](View&, Settings& s) { s.interleave = 2, s.samples = 2; });
    expect_refused("tile", [](View&, Settings& s) { s.tile_size = 12; });
    for (const int size : {-1, 1, 15, 8193})
        expect_refused("16 to 8192", [&](View&, Settings& s) { s.shadow_map_size = size; });
    for (const int filter : {-1, 0, 16})
        expect_refused("1 to 15", [&](View&, Settings& s) { s.shadow_filter = filter; });
    expect_refused("bias", [](View&, Settings& s) { s.shadow_bias = NAN; });
    expect_refused("bias", [](View&, Settings& s) { s.shadow_bias = INFINITY; });
    expect_refused("field of view", [](View& v, Settings&) { v.camera.fov_y_rad = 0; });
    expect_refused("field of view", [](View& v, Settings&) { v.camera.fov_y_rad = NAN; });
    expect_refused("too small", [](View& v, Settings&) { v.camera.fov_y_rad = 1e-300; });
    expect_refused("too small", [](View& v, Settings&) { v.camera.fov_y_rad = 5e-324; });
    expect_refused("camera", [](View& v, Settings&) { v.camera.direction = {0, 0, 0}; });
    expect_refused("camera", [](View& v, Settings&) { v.camera.up = v.camera.direction; });
    expect_refused("camera", [](View& v, Settings&) { v.camera.eye.x = INFINITY; });
}

} // namespace
} // namespace firsthit::test
