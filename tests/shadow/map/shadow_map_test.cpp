// shadow_map_test.cpp - which maps are made, and in which frames.
#include "map_scenes.h"

#include <gtest/gtest.h>

namespace firsthit::test {
namespace {

/// A world, a camera, and maps that are kept from frame to frame.
struct Frames {
    TestWorld world = box_over_floor();
    View view = straight_view(96, 80, 70);
    Settings settings;
    Tasks tasks{1};
    ShadowMaps maps;

    /// Renders a frame. Returns how many maps were made for it.
    std::uint64_t updates()
    {
        const std::uint64_t before = maps.updates;
        const HitPicture picture(world.world, view, tasks);
        make_maps(world.world, picture, settings, tasks, maps);
        return maps.updates - before;
    }

    int faces() const
    {
        int count = 0;
        for (const ShadowMap& map : maps.light[0].map) count += map.width() > 0;
        return count;
    }
};

TEST(ShadowMaps, StayWhereNothingChanges)
{
    Frames frames;
    frames.world.world.lights = {point_light({1, -3, 5}), directional_light({0.1, 1, 0})};
    EXPECT_EQ(frames.updates(), 2u);
    EXPECT_EQ(frames.updates(), 0u);
    frames.world.world.lights[0].color = {1, 0, 0};
    EXPECT_EQ(frames.updates(), 0u);
}

TEST(ShadowMaps, StayWhereTheCameraMovesLittle)
{
    Frames frames;
    frames.world.world.lights = {point_light({1, -3, 5})};
    EXPECT_EQ(frames.updates(), 1u);
    std::uint64_t updates = 0;
    for (int k = 0; k < 10; ++k) {
        frames.view.camera.eye.x += 0.002;
        updates += frames.updates();
    }
    EXPECT_LE(updates, 1u); // the rounding of the fit may take one step
    frames.view.camera.eye = {0, -20, 6};
    frames.view.camera.direction = {0, 1, 0.001};
    EXPECT_EQ(frames.updates(), 1u);
}

TEST(ShadowMaps, AreMadeAgainForALightThatMoves)
{
    Frames frames;
    frames.world.world.lights = {point_light({1, -3, 5}), point_light({2, -3, 5})};
    EXPECT_EQ(frames.updates(), 2u);
    frames.world.world.lights[1].position.x += 1e-6;
    EXPECT_EQ(frames.updates(), 1u);
    frames.world.world.lights[0] = spot_light({1, -3, 5}, {0, 1, 0}, 0.5);
    EXPECT_EQ(frames.updates(), 1u);
    frames.world.world.lights[0].direction.x += 1e-6;
    EXPECT_EQ(frames.updates(), 1u);
}

TEST(ShadowMaps, AreMadeAgainForGeometryThatMoves)
{
    Frames frames;
    frames.world.world.lights = {point_light({1, -3, 5})};
    EXPECT_EQ(frames.updates(), 1u);
    frames.world.world.position.back().x += 1e-6f;
    EXPECT_EQ(frames.updates(), 1u);
    std::swap(frames.world.scene->index.back().x, frames.world.scene->index.back().y);
    EXPECT_EQ(frames.updates(), 1u);
    frames.world.add({0, 0, 3}, {0.1f, 0, 3}, {0, 0.1f, 3});
    EXPECT_EQ(frames.updates(), 1u);
    EXPECT_EQ(frames.updates(), 0u);
}

TEST(ShadowMaps, AreMadeAgainForTrianglesThatChangeInAMovement)
{
    Frames frames;
    frames.world.world.lights = {point_light({1, -3, 5})};
    auto& x = frames.world.world.position.back().x;
    auto& triangle = frames.world.scene->index.back();
    for (int frame = 0; frame < 3; ++frame) {
        x += 1e-6f;
        std::swap(triangle.x, triangle.y);
        EXPECT_EQ(frames.updates(), 1u);
    }
    std::swap(triangle.x, triangle.y); // back to the triangle of the frame before the last
    EXPECT_EQ(frames.updates(), 1u);
    EXPECT_EQ(frames.updates(), 0u);
}

TEST(ShadowMaps, AreMadeAgainForGeometryThatMovedWhileALightDid)
{
    Frames frames;
    frames.world.world.lights = {point_light({1, -3, 5})};
    EXPECT_EQ(frames.updates(), 1u);
    // The vertex moves only in the second frame, in which all maps are made in any case, so that
    // the geometry is not compared.
    float& x = frames.world.world.position.back().x;
    const float before = x;
    x += 1e-6f;
    frames.world.world.lights[0].position.x += 1e-6;
    EXPECT_EQ(frames.updates(), 1u);
    x = before;
    EXPECT_EQ(frames.updates(), 1u);
    EXPECT_EQ(frames.updates(), 0u);
}

TEST(ShadowMaps, AreMadeAgainWhereOtherVerticesMove)
{
    Frames frames;
    for (int k = 0; k < 12000; ++k) frames.world.add({0, 0, 3}, {0.1f, 0, 3}, {0, 0.1f, 3});
    frames.world.world.lights = {point_light({1, -3, 5})};
    EXPECT_EQ(frames.updates(), 1u);
    std::vector<glm::vec3>& position = frames.world.world.position;
    for (int frame = 0; frame < 3; ++frame) {
        position.front().x += 1e-6f;
        position.back().x += 1e-6f;
        EXPECT_EQ(frames.updates(), 1u);
    }
    for (int frame = 0; frame < 3; ++frame) {
        position.back().x += 1e-6f;
        EXPECT_EQ(frames.updates(), 1u);
    }
    EXPECT_LE(frames.updates(), 1u); // not all vertices were compared while some moved
    EXPECT_EQ(frames.updates(), 0u);
}

TEST(ShadowMaps, DoNotDependOnEarlierFrames)
{
    Frames early, late;
    early.world.world.lights = late.world.world.lights = {point_light({1, -3, 5})};
    late.view.camera.eye = {0.5, -1, 0};
    late.updates();
    late.view.camera.eye = early.view.camera.eye;
    late.updates();
    early.updates();
    for (std::size_t face = 0; face < kFaces; ++face) {
        const ShadowMap &a = early.maps.light[0].map[face], &b = late.maps.light[0].map[face];
        ASSERT_EQ(a.source.fit, b.source.fit);
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x) ASSERT_EQ(a.at(x, y), b.at(x, y));
    }
}

TEST(ShadowMaps, HaveOneFaceForALightOutsideTheSceneAndMoreForOneInside)
{
    Frames frames;
    frames.world.world.lights = {point_light({1, -3, 5})};
    frames.updates();
    EXPECT_EQ(frames.faces(), 1);
    frames.world.world.lights = {spot_light({1, -3, 5}, {0, 1, 0}, 0.7)};
    frames.updates();
    EXPECT_EQ(frames.faces(), 1);
    frames.world.world.lights = {directional_light({0, 1, 0.3})};
    frames.updates();
    EXPECT_EQ(frames.faces(), 1);

    // A room with the light inside. The eye is at one side of the room and sees the other five.
    TestWorld room;
    add_box(room, {-3, -2, -1}, {3, 2, 9});
    room.finish();
    frames.world = room;
    frames.world.world.lights = {point_light({0, 0, 2})};
    frames.view = straight_view(160, 160, 40);
    frames.updates();
    EXPECT_EQ(frames.faces(), 5);
}

TEST(ShadowMaps, HaveTheSizeAskedFor)
{
    Frames frames;
    frames.world.world.lights = {point_light({1, -3, 5})};
    for (const int size : {16, 100, 1000}) {
        frames.settings.shadow_map_size = size;
        EXPECT_EQ(frames.updates(), 1u);
        for (const ShadowMap& map : frames.maps.light[0].map) {
            if (map.width() == 0) continue;
            EXPECT_EQ(std::max(map.width(), map.height()), size);
        }
    }
}

TEST(ShadowMaps, AreNoneWithoutHitsOrLights)
{
    Frames frames;
    EXPECT_EQ(frames.updates(), 0u); // no lights
    frames.world.world.lights = {point_light({1, -3, 5})};
    frames.view.camera.direction = {0, 0, -1};
    EXPECT_EQ(frames.updates(), 0u);
    EXPECT_EQ(frames.maps.texels, 0u);
    frames.world = TestWorld();
    frames.world.finish();
    frames.world.world.lights = {directional_light({0, 1, 0})};
    EXPECT_EQ(frames.updates(), 0u); // no triangles
}

TEST(ShadowMaps, WiderThanTheRasteriserCanTakeAreMadeInRectangles)
{
    Frames frames;
    frames.world.world.lights = {point_light({1, -3, 5})};
    frames.settings.shadow_map_size = kMaxPencil + 100;
    EXPECT_EQ(frames.updates(), 1u);
    for (std::size_t face = 0; face < kFaces; ++face) {
        const ShadowMap& map = frames.maps.light[0].map[face];
        const MapFit& fit = map.source.fit;
        // Columns on both sides of the cut show the floor or the box, at a depth of 3.5 to 5.
        for (const int x : {0, kMaxPencil / 2, kMaxPencil - 1, kMaxPencil, kMaxPencil + 50}) {
            if (x >= fit.width) continue;
            const int y = fit.height / 2;
            const double expected = plain_depth(frames.world.world, frames.maps.light[0], int(face),
                fit.middle_x + (x + 0.5 - 0.5 * fit.width) * fit.texel,
                fit.middle_y + (y + 0.5 - 0.5 * fit.height) * fit.texel);
            if (!std::isfinite(expected)) continue;
            EXPECT_NEAR(map.at(x, y), expected, 1e-5) << x;
        }
    }
}

TEST(ShadowMaps, OfFarAndDegenerateWorldsAreFinite)
{
    // Flat, tiny, huge or collapsed triangles: nothing crashes, and every visibility is 0 or 1.
    for (const float scale : {1e-20f, 1e-3f, 1e6f, 1e20f}) {
        for (const Light& light : {point_light(glm::dvec3(1, -3, 5) * double(scale)),
                 directional_light({0, 1, 0}), directional_light({1e-3, 1e-30, 0}),
                 spot_light(glm::dvec3(1, -3, 5) * double(scale), {0, 1, 0}, 1.5)}) {
            Frames frames;
            for (glm::vec3& p : frames.world.world.position) p *= scale;
            frames.world.add(glm::vec3(0), glm::vec3(0), glm::vec3(0));
            frames.world.world.lights = {light};
            frames.updates();
            const HitPicture picture(frames.world.world, frames.view, frames.tasks);
            const std::vector<TileVisibility> visibility =
                sample_all_maps(frames.maps, frames.world.world, picture);
            picture.for_hits([&](std::size_t tile, const HitTile&, int, int, int offset) {
                EXPECT_TRUE(
                    visibility[tile].value[offset] == 0 || visibility[tile].value[offset] == 1);
            });
        }
    }
}

} // namespace
} // namespace firsthit::test
