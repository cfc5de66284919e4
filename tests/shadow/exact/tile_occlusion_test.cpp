// tile_occlusion_test.cpp - occluder culling finds tiles under a roof, and no tile that has light.
#include "scene/model/borrow.h"
#include "shadow/exact/tile_occlusion.h"

#include "hits/hit_position.h"
#include "shadow/map/hit_picture.h"
#include "instruction_sets.h"
#include "rays/brute_shadows.h"
#include "shadow/shadow_builder.h"
#include "shadow/shadow_scenes.h"

#include <firsthit/firsthit.h>

#include <gtest/gtest.h>

namespace firsthit::test {
namespace {

/// Divides the scene into scene instances of `triangles` triangles each.
void divide(Scene& scene, std::uint32_t triangles)
{
    scene.instances[0].triangle_count = 0;
    const auto count = std::uint32_t(scene.index.size());
    for (std::uint32_t first = 0; first < count; first += triangles) {
        Instance instance;
        instance.first_vertex = std::uint32_t(scene.vertices);
        instance.first_triangle = first;
        instance.triangle_count = std::min(triangles, count - first);
        scene.instances.push_back(instance);
    }
}

struct Counts {
    std::size_t tiles = 0, hidden = 0; // of all lights
    std::size_t hits = 0, lit = 0;     // of hidden tiles; lit by brute force
};

std::vector<HitTile> tiles_of(const HitPicture& picture)
{
    std::vector<HitTile> tiles;
    for (const auto& tile : picture.tiles) tiles.push_back(tile->hits);
    return tiles;
}

/// Finds the hidden tiles of all lights, and tests each hit of a hidden tile by brute force.
Counts check(const World& world, const View& view, int tile_size = 8)
{
    Tasks tasks(2);
    const HitPicture picture(world, view, tasks, tile_size);
    const std::vector<HitTile> tiles = tiles_of(picture);
    TileOcclusion tile_occlusion;
    start_tile_occlusion(world, tiles.size(), tile_occlusion, tasks);
    EXPECT_TRUE(tile_occlusion.has_occluders());
    for (std::size_t k = 0; k < tiles.size(); ++k) add_hits(tiles[k], k, tile_occlusion);
    Counts counts;
    for (const Light& light : world.lights) {
        const PencilSpace space = light_space(light, view.camera.eye);
        const std::vector<glm::vec3> corner = all_to_light(space, world.position);
        const LightTriangles triangles{corner, world.scene->index};
        find_occluded_tiles(world, space, tiles, tile_occlusion, tasks);
        Effort effort;
        for (std::size_t k = 0; k < tiles.size(); ++k) {
            if (tiles[k].runs.empty()) continue;
            ++counts.tiles;
            if (!tile_occlusion.hidden[k]) continue;
            ++counts.hidden;
            for (const HitRun& run : tiles[k].runs) {
                const Corners c = triangles[run.item];
                const int side = light_side(space, c, effort);
                if (side != run.eye_side) continue;
                for (int s = 0; s < kBlockSamples; ++s) {
                    if (!(run.samples >> s & 1)) continue;
                    const int at = run.block * kBlockSamples + s, across = tile_size / kBlock;
                    const float x = float(run.block % across * kBlock + block_x(s)),
                                y = float(run.block / across * kBlock + block_y(s));
                    const glm::vec3 d = lifted(space,
                        to_light(space, hit_position(tiles[k].rays, x, y, tiles[k].t[at])),
                        receiver_of(c, side));
                    ++counts.hits;
                    counts.lit += !is_shadowed_brute(space, triangles, d, run.item, effort);
                }
            }
        }
    }
    return counts;
}

class TileOcclusionOf : public testing::TestWithParam<std::size_t> {};

TEST_P(TileOcclusionOf, HiddenTilesAreDarkByBruteForce)
{
    const ShadowScene& scene = shadow_scenes()[GetParam()];
    for (unsigned seed = 0; seed < 3; ++seed) {
        ShadowWorld made = make_shadow_world(scene, seed);
        divide(*made.world.scene, 1 + seed);
        for (const int tile_size : {8, 32})
            EXPECT_EQ(check(made.world.world, made.view, tile_size).lit, 0u)
                << scene.name << ", seed " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Adversarial, TileOcclusionOf,
    testing::Range(std::size_t(0), shadow_scenes().size()),
    [](const testing::TestParamInfo<std::size_t>& scene) {
        return shadow_test_name(shadow_scenes()[scene.param]);
    });

/// A floor of many triangles under a roof of one large triangle, and an eye between them.
ShadowWorld roofed(float height, float slope, const Light& light, float factor, glm::vec3 offset)
{
    ShadowWorld made;
    std::mt19937 random(1);
    Builder b{made, random};
    b.floor(0, 1, 12);
    b.triangle({-9, height - 9 * slope, -5}, {9, height + 9 * slope, -5}, {0, height, 20});
    b.light(light);
    b.eye({0, 0.5 * height, 1.2}, {0, 0.2 * height, 0});
    transform(made, factor, offset);
    made.world.finish();
    made.view.width = made.view.height = kShadowSize;
    made.view.region = {};
    divide(*made.world.scene, 1);
    return made;
}

/// With this direction the eye sees the floor only.
constexpr glm::dvec3 kDown{0, -1, -1};

TEST(TileOcclusion, HidesAllTilesUnderARoof)
{
    for (const Light& light : {point_light({0.3, 7, 0.2}), directional_light({0.2, -1, 0.1}),
             spot_light({0, 5, 0}, {0, -1, 0}, 0.5)}) {
        ShadowWorld made = roofed(1, 0, light, 1, glm::vec3(0));
        made.view.camera.direction = kDown;
        const Counts counts = check(made.world.world, made.view);
        EXPECT_GT(counts.tiles, 30u);
        EXPECT_EQ(counts.hidden, counts.tiles);
        EXPECT_EQ(counts.lit, 0u);
    }
}

/// Counts of a floor under a quad of two triangles. `against`: the triangles run through their
/// common edge in opposite directions, else in the same direction.
Counts check_quad(const std::array<glm::vec3, 4>& q, bool against, unsigned seed)
{
    ShadowWorld made;
    std::mt19937 random(seed);
    Builder b{made, random};
    b.floor(0, 1, 12);
    b.triangle(q[0], q[1], q[2]);
    if (against)
        b.triangle(q[0], q[2], q[3]);
    else
        b.triangle(q[2], q[0], q[3]);
    b.light(point_light({uniform(random, -1, 1), 7, uniform(random, -1, 1)}));
    b.eye({0, 0.5, 1}, {0, 0, 0});
    made.world.finish();
    made.view.width = made.view.height = kShadowSize;
    divide(*made.world.scene, 2);
    return check(made.world.world, made.view);
}

TEST(TileOcclusion, HasNoGapBetweenTheTwoTrianglesOfAQuad)
{
    for (const bool against : {false, true}) {
        const Counts counts =
            check_quad({{{-4, 1, -4}, {4, 1, -4}, {4, 1, 4}, {-4, 1, 4}}}, against, 1);
        EXPECT_GT(counts.tiles, 30u);
        EXPECT_EQ(counts.hidden, counts.tiles);
        EXPECT_EQ(counts.lit, 0u);
    }
}

TEST(TileOcclusion, DoesNotJoinTwoTrianglesOnTheSameSideOfTheirCommonEdge)
{
    // Some points are inside all edges but the common one, and beyond that one.
    for (const bool against : {false, true}) {
        const Counts counts =
            check_quad({{{-4, 1, 0}, {0, 1, -6}, {4, 1, 0}, {0.25f, 1.25f, -5}}}, against, 1);
        EXPECT_GT(counts.hidden, 5u);
        EXPECT_LT(counts.hidden, counts.tiles);
        EXPECT_EQ(counts.lit, 0u);
    }
}

TEST(TileOcclusion, SeesGapsBetweenTwoTrianglesThatAreBentFoldedOrApart)
{
    // Bent quads, quads folded over themselves, and quads with slightly moved corners.
    std::size_t hidden = 0;
    std::mt19937 random(3);
    for (unsigned seed = 0; seed < 60; ++seed) {
        std::array<glm::vec3, 4> q{{{-2, 1, -2}, {2, 1, -2}, {2, 1, 2}, {-2, 1, 2}}};
        for (glm::vec3& corner : q) corner += random_point(random, seed % 3 ? 1.0f : 2.5f);
        const Counts counts = check_quad(q, seed % 2, seed);
        EXPECT_EQ(counts.lit, 0u) << seed;
        hidden += counts.hidden;
    }
    EXPECT_GT(hidden, 100u);
}

TEST(TileOcclusion, StopsWhereTheRoofIsWithinTheRoundingMargins)
{
    // Heights from far below the margins to far above them. Both cases have to occur.
    std::size_t hidden = 0, open = 0;
    for (const float factor : {1.0f, 1e-6f, 1e5f})
        for (const glm::vec3& offset : {glm::vec3(0), glm::vec3(300, -200, 1000)})
            for (int k = 1; k < 27; k += 2) {
                const float height = std::ldexp(1.0f, -k);
                for (const float slope : {0.0f, 0.05f * height})
                    for (const Light& light :
                        {point_light({0.3, 7, 0.2}), directional_light({0.2, -1, 0.1}),
                            point_light({0.1, 2 * double(height), 0.1})}) {
                        const ShadowWorld made =
                            roofed(height, slope, light, factor, factor * offset);
                        const Counts counts = check(made.world.world, made.view);
                        EXPECT_EQ(counts.lit, 0u) << height << " " << factor;
                        hidden += counts.hidden;
                        open += counts.tiles - counts.hidden;
                    }
            }
    EXPECT_GT(hidden, 1000u);
    EXPECT_GT(open, 1000u);
}

TEST(TileOcclusion, HidesNoTileOnTheEdgeOfAShadow)
{
    // The shadow's edge crosses the picture.
    std::size_t hidden = 0, open = 0;
    std::mt19937 random(5);
    for (int k = 0; k < 40; ++k) {
        ShadowWorld made;
        Builder b{made, random};
        b.floor(0, 2, 16);
        b.quad({uniform(random, -2, 0), 1, -2}, {uniform(random, 0, 2), 1, -2}, {2, 1.2f, 2},
            {-2, 0.8f, 2});
        b.light(k % 2 ? point_light({uniform(random, -3, 3), 3, uniform(random, -3, 3)})
                      : directional_light({uniform(random, -1, 1), -1, uniform(random, -1, 1)}));
        b.eye({uniform(random, -1, 1), 0.75, uniform(random, 1, 2)});
        made.world.finish();
        made.view.width = made.view.height = kShadowSize;
        divide(*made.world.scene, 2);
        const Counts counts = check(made.world.world, made.view);
        EXPECT_EQ(counts.lit, 0u) << k;
        hidden += counts.hidden;
        open += counts.tiles - counts.hidden;
    }
    EXPECT_GT(hidden, 100u);
    EXPECT_GT(open, 100u);
}

TEST(TileOcclusion, IgnoresATriangleThatTheHitsLieOn)
{
    // The eye sees the floor, and the roof from below. The light is above the roof.
    ShadowWorld made = roofed(1, 0, point_light({0.3, 7, 0.2}), 1, glm::vec3(0));
    made.view.camera.direction = {0, 0.3, -1};
    const Counts counts = check(made.world.world, made.view);
    EXPECT_GT(counts.tiles, counts.hidden);
    EXPECT_EQ(counts.lit, 0u);
}

TEST(TileOcclusion, TriesTrianglesOfScenePartsWithFewTriangles)
{
    const auto occluders = [](std::uint32_t instances, std::uint32_t triangles,
                               std::uint32_t more) {
        Scene scene;
        scene.materials.resize(1);
        for (std::uint32_t k = 0; k < instances; ++k) {
            Instance instance;
            instance.first_triangle = k * triangles;
            instance.triangle_count = triangles;
            scene.instances.push_back(instance);
        }
        Instance last;
        last.first_triangle = instances * triangles;
        last.triangle_count = more;
        scene.instances.push_back(last);
        World world;
        world.scene = borrow(scene);
        TileOcclusion tile_occlusion;
        Tasks tasks(1);
        start_tile_occlusion(world, 0, tile_occlusion, tasks);
        return std::vector<std::uint32_t>(
            tile_occlusion.occluders.span().begin(), tile_occlusion.occluders.span().end());
    };
    EXPECT_EQ(occluders(1, 2, 3), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
    EXPECT_EQ(occluders(1, 2, 1000), (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(occluders(0, 2, 1000).size(), 0u);
    EXPECT_EQ(occluders(1000, 12, 2), (std::vector<std::uint32_t>{12000, 12001}))
        << "too many boxes";
    EXPECT_EQ(occluders(10'000'000 / 12, 12, 1000).size(), 0u);
}

TEST(TileOcclusion, IsTheSameForEveryInstructionSet)
{
    const ShadowWorld made = roofed(0.01f, 0, point_light({0.3, 7, 0.2}), 1, glm::vec3(5));
    const Counts expected = check(made.world.world, made.view);
    for_instruction_sets(
        [&] { EXPECT_EQ(check(made.world.world, made.view).hidden, expected.hidden); });
}

/// A frame of the roofed floor. `culling`: the roof is a scene instance of its own, so that it is an
/// occluder.
struct RoofedFrame {
    Film film;
    Stats stats;

    RoofedFrame(bool culling, Shadows shadows, const Light& light, double bias = -1)
    {
        ShadowWorld made = roofed(1, 0, light, 1, glm::vec3(0));
        made.view.camera.direction = kDown;
        if (!culling) made.world.finish();
        Settings settings;
        settings.shadows = shadows;
        settings.tile_size = 16;
        settings.shadow_bias = bias;
        Renderer renderer(2);
        renderer.render(made.world.world, made.view, settings, film);
        stats = renderer.stats();
    }
};

TEST(TileOcclusion, SavesAllTestsAndMapsAndDoesNotChangeThePicture)
{
    for (const Shadows shadows : {Shadows::exact, Shadows::map}) {
        const RoofedFrame with(true, shadows, point_light({0.3, 7, 0.2})),
            without(false, shadows, point_light({0.3, 7, 0.2}));
        EXPECT_EQ(with.film.color.value, without.film.color.value);
        EXPECT_EQ(with.stats.shadow_points, 0u);
        EXPECT_EQ(with.stats.map_updates, 0u);
        EXPECT_GT(without.stats.shadow_points + without.stats.map_updates, 0u);
    }
}

TEST(TileOcclusion, IsOffWhereAMapBiasLetsLightThroughTheOccluder)
{
    const Light light = point_light({0.3, 7, 0.2});
    const RoofedFrame with(true, Shadows::map, light, 2);
    EXPECT_EQ(with.film.color.value, RoofedFrame(false, Shadows::map, light, 2).film.color.value);
    EXPECT_NE(with.film.color.value, RoofedFrame(true, Shadows::map, light).film.color.value);
}

TEST(TileOcclusion, KeepsTheWholeMapOfALightThatReachesSomeTiles)
{
    // Half of the hits are in the roof's shadow. The map is the same as without culling.
    const Light low = point_light({-3, 0.7, 0.2});
    EXPECT_EQ(RoofedFrame(true, Shadows::map, low).film.color.value,
        RoofedFrame(false, Shadows::map, low).film.color.value);
}

} // namespace
} // namespace firsthit::test
