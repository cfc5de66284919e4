// sample_shadow_map_test.cpp - shadow map sampling, against rays in double through texel centres.
#include "instruction_sets.h"
#include "shadow/map/map_scenes.h"

#include <cstring>
#include <functional>

namespace firsthit::test {
namespace {

struct Case {
    std::string name;
    std::function<TestWorld()> world;
    Light light;
};

/// A room around the eye and a light, with a box between them.
TestWorld room()
{
    TestWorld world;
    add_box(world, {-3, -2, -1}, {3, 2, 9});
    add_box(world, {-2, 1, 4}, {-1, 2, 5});
    add_box(world, {1, -1, 6}, {2, 0, 7});
    world.finish();
    return world;
}

/// A floor under a roof that slopes down to the floor on the left and ends on the right, with a hut
/// between them. Some tiles are wholly dark, others nearly.
TestWorld roofed()
{
    TestWorld world;
    add_quad(world, {-4, 2, 2}, {8, 0, 0}, {0, 0, 8});
    add_quad(world, {-4, 1.999f, 1}, {5, -3, 0}, {0, 0, 9});
    add_box(world, {-0.5f, 1.6f, 5}, {0, 2, 6});
    world.finish();
    return world;
}

/// A table in front of a wall, lit from above, over a dark floor. Some tiles see both table and
/// floor, while their texels of the map show only the table.
TestWorld table()
{
    TestWorld world;
    add_quad(world, {-12, 2, 2}, {24, 0, 0}, {0, 0, 18});
    add_quad(world, {-12, 1, 3.3f}, {24, 0, 0}, {0, 0, 16});
    add_quad(world, {-12, 1, 12}, {24, 0, 0}, {0, -7, 0});
    add_quad(
        world, {-12, -1, -2}, {24, 0, 0}, {0, 0, 5.3f}); // a roof over the eye, up to the table
    world.finish();
    return world;
}

std::vector<Case> cases()
{
    return {
        {"point light above", box_over_floor, point_light({1, -3, 5})},
        {"point light in a room", room, point_light({0.1, 0.2, 3.7})},
        {"directional light", box_over_floor, directional_light({1, 2, 0.5})},
        {"directional light along an axis", box_over_floor, directional_light({0, 3, 0})},
        {"spot light", box_over_floor, spot_light({1, -3, 5}, {-0.2, 1, 0.2}, 0.5)},
        {"point light above a roof", roofed, point_light({0, -6, 5})},
        {"directional light above a roof", roofed, directional_light({0.2, 2, 0.1})},
        {"wide spot light", room, spot_light({0, -1.9, 4}, {0, 1, 0}, 1.4)},
    };
}

View small_view()
{
    return straight_view(96, 80, 70);
}

struct Agreement {
    int lit = 0, dark = 0, between = 0, wrong = 0;
};

/// Compares every hit whose visibility does not depend on the last bits of float.
Agreement agreement(const ShadowMaps& maps, const World& world, const HitPicture& picture)
{
    const std::vector<TileVisibility> visibility = sample_all_maps(maps, world, picture);
    const Light& light = world.lights[0];
    Agreement count;
    picture.for_hits([&](std::size_t tile, const HitTile& hits, int x, int y, int offset) {
        const PlainHit plain = plain_hit(maps, world, hits, x, y, offset);
        const float ours = visibility[tile].value[offset];
        double expected = 0;
        bool sure = true;
        if (light.kind == Light::Kind::spot) {
            const glm::dvec3 d =
                glm::dvec3(hit_position(hits.rays, float(x), float(y), hits.t[offset])) -
                light.position;
            const double angle =
                std::acos(glm::dot(glm::normalize(d), glm::normalize(light.direction)));
            sure = std::abs(angle - light.outer_rad) > 1e-5;
            if (angle > light.outer_rad) {
                if (sure) count.wrong += ours != 0;
                return;
            }
        }
        if (plain.faces_light) {
            ASSERT_GE(plain.face, 0);
            const ShadowMap& map = maps.light[0].map[std::size_t(plain.face)];
            const MapFit& fit = map.source.fit;
            const int n = maps.filter;
            const double half = 0.5 * (n - 1);
            const double column = std::floor(plain.column - half),
                         row = std::floor(plain.row - half);
            sure = sure &&
                   std::abs(std::round(plain.column - half) - (plain.column - half)) > 2e-3 &&
                   std::abs(std::round(plain.row - half) - (plain.row - half)) > 2e-3;
            for (int k = 0; k < n * n; ++k) {
                const double i = std::clamp(column + k % n, 0.0, double(fit.width - 1));
                const double j = std::clamp(row + k / n, 0.0, double(fit.height - 1));
                const double x_at = fit.middle_x + (i + 0.5 - 0.5 * fit.width) * fit.texel;
                const double y_at = fit.middle_y + (j + 0.5 - 0.5 * fit.height) * fit.texel;
                const double depth = plain_depth(world, maps.light[0], plain.face, x_at, y_at);
                // An edge of a triangle may run through the texel's centre.
                for (const double e : {-1e-4, 1e-4})
                    for (const auto& [dx, dy] : {std::pair(e, 0.0), std::pair(0.0, e)})
                        sure = sure &&
                               (plain_depth(world, maps.light[0], plain.face, x_at + dx * fit.texel,
                                    y_at + dy * fit.texel) < plain.depth - plain.epsilon) ==
                                   (depth < plain.depth - plain.epsilon);
                sure = sure && !(std::abs(depth - (plain.depth - plain.epsilon)) < 2e-5);
                expected += depth < plain.depth - plain.epsilon ? 0.0 : 1.0 / (n * n);
            }
        }
        if (!sure) return;
        ++(expected < 1e-6 ? count.dark : expected > 1 - 1e-6 ? count.lit : count.between);
        if (std::abs(double(ours) - expected) > 1e-6 && ++count.wrong < 6)
            ADD_FAILURE() << "tile " << tile << " (" << x << ", " << y << "): " << ours
                          << ", expected " << expected << ", face " << plain.face;
    });
    return count;
}

TEST(SampleShadowMap, AgreesWithRaysThroughTexelCentres)
{
    for (const Case& c : cases()) {
        for (const int filter : {1, 2, 3}) {
            SCOPED_TRACE(c.name + ", filter " + std::to_string(filter));
            TestWorld world = c.world();
            world.world.lights = {c.light};
            Tasks tasks(1);
            const HitPicture picture(world.world, small_view(), tasks, 32);
            Settings settings;
            settings.shadow_map_size = 120;
            settings.shadow_filter = filter;
            ShadowMaps maps;
            make_maps(world.world, picture, settings, tasks, maps);
            const Agreement count = agreement(maps, world.world, picture);
            EXPECT_EQ(count.wrong, 0);
            EXPECT_GT(count.lit, 500);
            EXPECT_GT(count.dark, 40);
            EXPECT_EQ(count.between > 0, filter > 1);
        }
    }
}

TEST(SampleShadowMap, DoesNotDarkenATileThatIsPartlyLit)
{
    TestWorld world = table();
    world.world.lights = {directional_light({0, 2, 0})};
    Tasks tasks(1);
    const HitPicture picture(world.world, small_view(), tasks, 32);
    Settings settings;
    settings.shadow_map_size = 120;
    ShadowMaps maps;
    make_maps(world.world, picture, settings, tasks, maps);
    const Agreement count = agreement(maps, world.world, picture);
    EXPECT_EQ(count.wrong, 0);
    EXPECT_GT(count.lit, 500);
    EXPECT_GT(count.dark, 500);
}

TEST(SampleShadowMap, GivesTheSameBitsOnEveryInstructionSetAndForAnyNumberOfThreads)
{
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.name);
        TestWorld world = c.world();
        world.world.lights = {c.light};
        Settings settings;
        settings.shadow_filter = 2;
        std::vector<float> first;
        const auto check = [&](int threads) {
            Tasks tasks(threads);
            const HitPicture picture(world.world, small_view(), tasks, 32);
            ShadowMaps maps;
            make_maps(world.world, picture, settings, tasks, maps);
            const std::vector<TileVisibility> visibility =
                sample_all_maps(maps, world.world, picture);
            std::vector<float> all;
            picture.for_hits([&](std::size_t tile, const HitTile&, int, int, int offset) {
                all.push_back(visibility[tile].value[offset]);
            });
            if (first.empty()) first = all;
            ASSERT_EQ(all.size(), first.size());
            EXPECT_EQ(std::memcmp(all.data(), first.data(), all.size() * sizeof(float)), 0);
        };
        for_instruction_sets([&] { check(1); });
        check(3);
        EXPECT_GT(first.size(), 1000u);
    }
}

TEST(SampleShadowMap, GivesAPlaneNoShadowAcne)
{
    // The light sees the floor from the front to nearly edge-on, and maps are small, so that any
    // acne would show.
    for (const int filter : {1, 4}) {
        for (const double height : {10.0, 2.0, 0.5, 0.1, 0.02}) {
            for (const Light& light :
                {point_light({3, 2 - height, 3}), directional_light({-1, height / 5, 0.7})}) {
                TestWorld world;
                add_quad(world, {-4, 2, 2}, {8, 0, 0}, {0, 0, 8});
                world.finish();
                world.world.lights = {light};
                Tasks tasks(1);
                const HitPicture picture(world.world, small_view(), tasks);
                Settings settings;
                settings.shadow_map_size = 50;
                settings.shadow_filter = filter;
                ShadowMaps maps;
                make_maps(world.world, picture, settings, tasks, maps);
                const std::vector<TileVisibility> visibility =
                    sample_all_maps(maps, world.world, picture);
                int hits = 0, dark = 0;
                picture.for_hits([&](std::size_t tile, const HitTile&, int, int, int offset) {
                    ++hits;
                    dark += visibility[tile].value[offset] != 1;
                });
                EXPECT_GT(hits, 1000);
                EXPECT_EQ(dark, 0) << height << " of " << hits;
            }
        }
    }
}

/// The fraction of the floor's hits that are in shadow.
double dark_floor(const Settings& settings)
{
    TestWorld world = box_over_floor();
    world.world.lights = {directional_light({0.3, 1, 0.1})};
    Tasks tasks(1);
    const HitPicture picture(world.world, small_view(), tasks);
    ShadowMaps maps;
    make_maps(world.world, picture, settings, tasks, maps);
    const std::vector<TileVisibility> visibility = sample_all_maps(maps, world.world, picture);
    int hits = 0, dark = 0;
    picture.for_hits([&](std::size_t tile, const HitTile& tile_hits, int, int, int offset) {
        if (tile_hits.item[offset] > 1) return;
        ++hits;
        dark += visibility[tile].value[offset] == 0;
    });
    return double(dark) / hits;
}

TEST(SampleShadowMap, HonoursTheBias)
{
    Settings settings;
    const double shadow = dark_floor(settings);
    EXPECT_GT(shadow, 0.01);
    EXPECT_LT(shadow, 0.2);
    settings.shadow_bias = 0.1; // more than depth changes in a texel, less than box to floor
    EXPECT_NEAR(dark_floor(settings), shadow, 0.2 * shadow);
    settings.shadow_bias = 1; // reaches between the lower and the upper side of the box
    EXPECT_NEAR(dark_floor(settings), shadow, 0.2 * shadow);
    settings.shadow_bias = 2; // reaches beyond the upper side of the box
    EXPECT_EQ(dark_floor(settings), 0);
    settings.shadow_bias = 0;
    settings.shadow_map_size = 50;
    EXPECT_GT(dark_floor(settings), 2 * shadow); // acne
}

TEST(SampleShadowMap, LetsShadowsBeginAtTheirCasters)
{
    // A wall on a floor, lit from behind. The floor in front of the wall is dark up to the wall,
    // except for a texel or two.
    TestWorld world;
    add_quad(world, {-4, 2, 2}, {8, 0, 0}, {0, 0, 8});
    add_quad(world, {-4, 1, 6}, {8, 0, 0}, {0, 1, 0});
    world.finish();
    world.world.lights = {directional_light({0, 1, -1})};
    Tasks tasks(1);
    const HitPicture picture(world.world, small_view(), tasks);
    ShadowMaps maps;
    make_maps(world.world, picture, {}, tasks, maps);
    const std::vector<TileVisibility> visibility = sample_all_maps(maps, world.world, picture);
    const double texel = maps.light[0].map[kOnlyFace].source.fit.texel;
    int dark = 0;
    picture.for_hits([&](std::size_t tile, const HitTile& hits, int x, int y, int offset) {
        const glm::vec3 p = hit_position(hits.rays, float(x), float(y), hits.t[offset]);
        if (hits.item[offset] > 1) return;
        const double before = 6 - double(p.z); // distance from the wall; the shadow ends at 1
        if (before < 4 * texel || std::abs(before - 1) < 4 * texel) return;
        EXPECT_EQ(visibility[tile].value[offset], before > 1 ? 1 : 0) << p.x << " " << p.z;
        dark += before < 1;
    });
    EXPECT_GT(dark, 200);
}

/// Expects that the light reaches no hit.
void expect_dark(const World& world)
{
    Tasks tasks(1);
    const HitPicture picture(world, small_view(), tasks);
    ShadowMaps maps;
    make_maps(world, picture, {}, tasks, maps);
    const std::vector<TileVisibility> visibility = sample_all_maps(maps, world, picture);
    int hits = 0;
    picture.for_hits([&](std::size_t tile, const HitTile&, int, int, int offset) {
        EXPECT_EQ(visibility[tile].value[offset], 0);
        ++hits;
    });
    EXPECT_GT(hits, 1000);
}

TEST(SampleShadowMap, IsDarkWhereTheLightIsBehindThePlane)
{
    TestWorld world;
    add_quad(world, {-4, 2, 2}, {8, 0, 0}, {0, 0, 8});
    world.finish();
    world.world.lights = {point_light({0, 3, 5})}; // below the floor
    expect_dark(world.world);
}

TEST(SampleShadowMap, IsDarkWhereTheLightLiesInThePlane)
{
    // Rounding may put the light slightly above the plane, which must not light the whole plane.
    TestWorld world;
    const glm::vec3 corner(-4, 1.5f, 2), along(8, 0.7f, 0.1f), across(0.3f, 0.4f, 8);
    add_quad(world, corner, along, across);
    world.finish();
    for (const float share : {0.1f, 0.3f, 0.77f}) {
        world.world.lights = {point_light(glm::dvec3(corner) + double(share) * glm::dvec3(along) +
                                          (1.0 - double(share)) * glm::dvec3(across))};
        expect_dark(world.world);
    }
}

} // namespace
} // namespace firsthit::test
