// cutout_test.cpp - cut-outs in all that the cpu engine answers: items and shadows against brute
// force, and against scenes whose holes are made of triangles.
#include "cpu/adversarial_scenes.h"
#include "cutouts.h"
#include "instruction_sets.h"
#include "items.h"
#include "lights.h"
#include "message_of.h"
#include "rays/brute_shadows.h"
#include "shadow/exact/point_shadows.h"
#include "shadow/shadow_scenes.h"
#include "visibility/lazy_items.h"

#include <firsthit/firsthit.h>

#include <gtest/gtest.h>

#include <cmath>

namespace firsthit::test {
namespace {

template <class F>
void for_cutout_worlds(const F& check)
{
    for (const AdversarialScene& scene : adversarial_scenes()) {
        for (unsigned seed = 0; seed < 4; ++seed) {
            SCOPED_TRACE(scene.name + ", seed " + std::to_string(seed));
            std::mt19937 random(seed);
            TestWorld world;
            scene.fill(world, random);
            world.finish();
            make_cutouts(world, random, seed % 2 == 0);
            check(world);
        }
    }
}

const View kView = straight_view(kSize, kSize, kSize);

TEST(CutoutItems, EqualBruteForce)
{
    std::size_t changed = 0;
    for_cutout_worlds([&](TestWorld& world) {
        const auto items = items_of(world.world, kView);
        EXPECT_EQ(differences(items, brute_items(world.world, kView), kSize), 0u);
        for (const int tile : {8, 40, 128}) EXPECT_EQ(items_of(world.world, kView, 3, tile), items);
        const Comparison all = compare(world.world, kView, Oracle::brute, 1);
        EXPECT_EQ(all.agree, all.pixels);
        EXPECT_EQ(compare(world.world, kView, Oracle::embree, 1).ours_wrong, 0u);
        for (Material& material : world.scene->materials) material.alpha = AlphaMode::opaque;
        changed += items_of(world.world, kView) != items;
    });
    EXPECT_GT(changed, 2 * adversarial_scenes().size()); // of four times as many
}

TEST(CutoutItems, AreTheSameForEveryInstructionSet)
{
    for_cutout_worlds([&](TestWorld& world) {
        const auto expected = items_of(world.world, kView);
        for_instruction_sets([&] { EXPECT_EQ(items_of(world.world, kView), expected); });
    });
}

TEST(CutoutItems, OfListedSamplesAreTheSame)
{
    for_cutout_worlds([&](TestWorld& world) {
        const EyeWorld eye(world.world, kView);
        std::vector<ListedSample> samples;
        for (int k = 0; k < kSize * kSize; ++k)
            samples.push_back({std::uint16_t(k % kSize), std::uint16_t(k / kSize)});
        Tasks tasks(2);
        LazyMemory memory;
        const auto found =
            find_listed_items(eye.memory.pencil, eye.memory, {samples}, memory, tasks);
        EXPECT_EQ(
            std::vector<std::uint32_t>(found.begin(), found.end()), items_of(world.world, kView));
    });
}

TEST(CutoutShadows, EqualBruteForce)
{
    for (const ShadowScene& scene : shadow_scenes()) {
        for (unsigned seed = 0; seed < 3; ++seed) {
            SCOPED_TRACE(scene.name + ", seed " + std::to_string(seed));
            ShadowWorld made = make_shadow_world(scene, seed);
            std::mt19937 random(seed);
            make_cutouts(made.world, random, seed % 2 == 0);
            const World& world = made.world.world;
            const Comparison items = compare(world, made.view, Oracle::brute, 1);
            EXPECT_EQ(items.agree, items.pixels);
            const LitComparison lit = compare_lit(world, made.view, Oracle::brute, 2);
            EXPECT_EQ(lit.agree, lit.pixels);
            EXPECT_EQ(compare_lit(world, made.view, Oracle::embree, 1).ours_wrong, 0u);
        }
    }
}

/// Of given points, by each plan.
TEST(CutoutShadows, OfPointsEqualBruteForce)
{
    std::size_t shadowed = 0, freed = 0;
    for (const ShadowScene& scene : shadow_scenes()) {
        SCOPED_TRACE(scene.name);
        ShadowWorld made = make_shadow_world(scene, 5);
        std::mt19937 random(5);
        make_cutouts(made.world, random, false);
        const World& world = made.world.world;
        const ShadowPoints points = shadow_points(made, 600, 1);
        Tasks tasks(2);
        for (const Light& light : world.lights) {
            const PencilSpace space = light_space(light, glm::dvec3(0));
            const std::vector<glm::vec3> corner = all_to_light(space, world.position);
            Cutouts cutouts;
            cutouts.find(*world.scene, kShadowOpacity);
            const LightTriangles triangles{corner, world.scene->index, &cutouts};
            std::vector<std::uint8_t> expected;
            Effort effort;
            for (std::size_t k = 0; k < points.point.size(); ++k) {
                glm::vec3 d = to_light(space, points.point[k]);
                if (points.receiver[k] != kNoItem) {
                    const Corners own = triangles[points.receiver[k]];
                    d = lifted(space, d, receiver_of(own, light_side(space, own, effort)));
                }
                expected.push_back(
                    is_shadowed_brute(space, triangles, d, points.receiver[k], effort));
                shadowed += expected.back();
                freed += !expected.back() && is_shadowed_brute(space, {corner, world.scene->index},
                                                 d, points.receiver[k], effort);
            }
            PointSet set;
            make_point_set(points.point, points.receiver, false, set, tasks);
            for (const ShadowPlan plan : {ShadowPlan::grid, ShadowPlan::cells}) {
                ShadowMemory memory;
                memory.plan = plan;
                std::vector<std::uint8_t> found(points.point.size());
                test_points({world, space}, set, memory, tasks, found);
                EXPECT_EQ(found, expected) << int(plan);
            }
        }
    }
    EXPECT_GT(shadowed, 200u);
    EXPECT_GT(freed, 200u); // that opaque triangles would shadow
}

/// A floor, and a screen above it with kCells x kCells cells, each of which is there or not: as a
/// texture's nearest texels, or as triangles.
constexpr int kCells = 8;

bool has_cell(int column, int row)
{
    return (column * 5 + row * 3 + column * row) % 3 != 0;
}

TestWorld screen_world(bool textured, AlphaMode alpha)
{
    TestWorld made;
    Scene& scene = *made.scene;
    const auto quad = [&](glm::vec3 low, glm::vec3 high, glm::vec2 uv_low, glm::vec2 uv_high) {
        made.add(low, {high.x, low.y, low.z}, high);
        made.add(low, high, {low.x, low.y, high.z});
        for (const glm::vec2 uv :
            {uv_low, {uv_high.x, uv_low.y}, uv_high, uv_low, uv_high, {uv_low.x, uv_high.y}})
            scene.uv.push_back(uv);
    };
    quad({-4, 0, -4}, {4, 0, 4}, {0, 0}, {1, 1}); // y is up here
    if (textured) {
        quad({-1, 1.5f, -1}, {1, 1.5f, 1}, {0, 0}, {1, 1});
    } else {
        for (int column = 0; column < kCells; ++column)
            for (int row = 0; row < kCells; ++row)
                if (has_cell(column, row)) {
                    const float x = -1 + 0.25f * float(column), z = -1 + 0.25f * float(row);
                    quad({x, 1.5f, z}, {x + 0.25f, 1.5f, z + 0.25f}, {0, 0}, {1, 1});
                }
    }
    made.finish();
    std::vector<int> alphas(kCells * kCells);
    for (int column = 0; column < kCells; ++column)
        for (int row = 0; row < kCells; ++row) // texture row 0 is at the top, v = 1
            alphas[std::size_t((kCells - 1 - row) * kCells + column)] =
                has_cell(column, row) ? 255 : 0;
    Texture texture = alpha_texture(kCells, kCells, alphas);
    texture.set_sampler({Wrap::clamp, Wrap::clamp, true});
    scene.textures = {std::move(texture)};
    scene.instances[0].triangle_count = 2;
    Instance screen = scene.instances[0];
    screen.first_triangle = 2;
    screen.triangle_count = std::uint32_t(scene.index.size()) - 2;
    screen.material = 1;
    scene.instances.push_back(screen);
    for (std::size_t t = 2; t < scene.index.size(); ++t) scene.owner[t] = 1;
    scene.materials.resize(2);
    if (textured) {
        scene.materials[1].alpha = alpha;
        scene.materials[1].opacity_texture.texture = 0;
    }
    return made;
}

View screen_view(int size)
{
    View view;
    view.width = view.height = size;
    view.camera.eye = {2.1, 4.3, 3.2};
    view.camera.direction = {-0.43, -0.8, -0.61};
    view.camera.up = {0, 1, 0};
    view.camera.fov_y_rad = 0.9;
    return view;
}

Film lit_picture(const World& world, int size, Shadows shadows)
{
    Renderer renderer(1);
    Settings settings;
    settings.engine = Engine::cpu;
    settings.color = false;
    settings.aovs = {Aov::depth, Aov::lit};
    settings.shadows = shadows;
    settings.shadow_map_size = 1024;
    Film film;
    renderer.render(world, screen_view(size), settings, film);
    return film;
}

double apart(const std::vector<float>& a, const std::vector<float>& b, float by)
{
    EXPECT_EQ(a.size(), b.size());
    std::size_t count = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
        count += !(std::abs(a[k] - b[k]) <= by) && a[k] != b[k];
    return double(count) / double(a.size());
}

/// Both ways to make holes look alike, to the eye and to lights: this knows nothing of how opacity is
/// found.
TEST(CutoutShadows, AreThoseOfHolesMadeOfTriangles)
{
    constexpr int kPixels = 300;
    const std::vector<Light> lights{point_light({0.7, 4.1, -0.9}),
        directional_light({-0.31, -1, 0.22}), spot_light({-1.1, 3.9, 0.4}, {0.3, -1, -0.1}, 0.9)};
    for (const AlphaMode alpha : {AlphaMode::mask, AlphaMode::blend}) {
        TestWorld textured = screen_world(true, alpha), cells = screen_world(false, alpha);
        TestWorld solid = screen_world(true, AlphaMode::opaque);
        for (TestWorld* world : {&textured, &cells, &solid}) {
            world->world.lights = world->scene->lights = lights;
        }
        for (const Shadows shadows : {Shadows::exact, Shadows::map}) {
            SCOPED_TRACE(int(shadows));
            const Film a = lit_picture(textured.world, kPixels, shadows),
                       b = lit_picture(cells.world, kPixels, shadows),
                       none = lit_picture(solid.world, kPixels, shadows);
            EXPECT_LT(apart(a[Aov::depth].value, b[Aov::depth].value, 1e-4f), 0.0001);
            EXPECT_GT(apart(a[Aov::depth].value, none[Aov::depth].value, 1e-4f), 0.01);
            const bool exact = shadows == Shadows::exact;
            EXPECT_LT(apart(a[Aov::lit].value, b[Aov::lit].value, 0.1f), exact ? 0.0001 : 0.002);
            EXPECT_GT(apart(a[Aov::lit].value, none[Aov::lit].value, 0.1f), 0.01);
        }
    }
}

/// A map is not kept where only the material has changed.
TEST(CutoutShadows, OfMapsFollowTheMaterial)
{
    TestWorld made = screen_world(true, AlphaMode::mask);
    made.world.lights = made.scene->lights = {point_light({0.7, 4.1, -0.9})};
    Renderer renderer(1);
    Settings settings;
    settings.engine = Engine::cpu;
    settings.color = false;
    settings.aovs = {Aov::lit};
    settings.shadows = Shadows::map;
    Film film;
    const auto picture = [&] {
        renderer.render(made.world, screen_view(96), settings, film);
        return film[Aov::lit].value;
    };
    Material& material = made.scene->materials[1];
    const auto masked = picture();
    material.alpha = AlphaMode::opaque;
    const auto solid = picture();
    EXPECT_NE(solid, masked);
    material.alpha = AlphaMode::mask;
    EXPECT_EQ(picture(), masked);
    material.alpha_cutoff = 2;
    const auto nothing = picture();
    EXPECT_NE(nothing, masked);
    EXPECT_NE(nothing, solid);
}

/// A wall that would hide whole tiles, and lies in the plane of others, hides nothing where it has
/// holes only.
TEST(CutoutShadows, AreNotCulledByWallsThatAreNotThere)
{
    for (const float cutoff : {0.0f, 0.5f, 1.0f, 1.5f}) {
        TestWorld made;
        made.add({-9, 0, -9}, {9, 0, -9}, {9, 0, 9});
        made.add({-9, 0, -9}, {9, 0, 9}, {-9, 0, 9});
        made.add({-9, 2, -9}, {9, 2, -9}, {9, 2, 9});
        made.add({-9, 2, -9}, {9, 2, 9}, {-9, 2, 9});
        made.finish();
        Scene& scene = *made.scene;
        scene.instances.push_back(scene.instances[0]);
        scene.instances[0].triangle_count = scene.instances[1].triangle_count = 2;
        scene.instances[1].first_triangle = 2;
        scene.instances[1].material = 1;
        scene.owner = {0, 0, 1, 1};
        scene.materials.resize(2);
        scene.materials[1].alpha = AlphaMode::mask;
        scene.materials[1].alpha_cutoff = cutoff;
        scene.color.assign(made.world.position.size(), glm::vec4(1)); // it might vary
        made.world.lights = scene.lights = {point_light({0.3, 7, 0.2})};
        View view = screen_view(64);
        view.camera.eye = {0.4, 1.5, 3};
        view.camera.direction = {0, -0.9, -1};
        const LitComparison lit = compare_lit(made.world, view, Oracle::brute, 1);
        EXPECT_EQ(lit.agree, lit.pixels) << cutoff;
        Settings settings;
        settings.engine = Engine::cpu;
        settings.color = false;
        settings.aovs = {Aov::lit};
        settings.tile_size = 8; // so that one triangle may hide a tile
        for (const Shadows shadows : {Shadows::exact, Shadows::map}) {
            settings.shadows = shadows;
            Renderer renderer(1);
            Film film;
            renderer.render(made.world, view, settings, film);
            const std::vector<float>& value = film[Aov::lit].value;
            const double share =
                double(std::count(value.begin(), value.end(), 1.0f)) / double(value.size());
            if (cutoff > 1)
                EXPECT_GT(share, 0.5);
            else
                EXPECT_EQ(share, 0.0);
        }
    }
}

TEST(Cutouts, AreRefusedByEmbreesFrame)
{
    TestWorld made;
    made.add({-1, -1, 2}, {1, -1, 2}, {1, 1, 2});
    made.finish();
    made.scene->materials[0].alpha = AlphaMode::mask;
    made.scene->materials[0].alpha_cutoff = 1.5f;
    EmbreeBaseline baseline(made.scene, BaselineUpdate::refit, 1);
    Settings settings;
    settings.shadows = Shadows::exact;
    Film film;
    EXPECT_NE(message_of<ArgumentError>([&] {
        baseline.render(screen_view(32), settings, film);
    }).find("cut-outs"),
        std::string::npos);
}

} // namespace
} // namespace firsthit::test
