// point_shadows_test.cpp - the irregular z-buffer against a brute-force loop over all triangles.
#include "scene/model/borrow.h"
#include "shadow/exact/point_shadows.h"

#include "instruction_sets.h"
#include "scenes.h"

#include <firsthit/scene.h>

#include <gtest/gtest.h>

#include <random>

namespace firsthit {
namespace {

/// Tests every point against every triangle.
std::vector<std::uint8_t> brute(const World& world, const PencilSpace& space,
    const std::vector<glm::vec3>& points, const std::vector<std::uint32_t>& receivers)
{
    Effort effort;
    std::vector<Corners> triangles;
    for (const glm::uvec3& c : world.scene->index)
        triangles.push_back({to_light(space, world.position[c.x]),
            to_light(space, world.position[c.y]), to_light(space, world.position[c.z])});
    std::vector<std::uint8_t> shadowed;
    for (std::size_t k = 0; k < points.size(); ++k) {
        glm::vec3 d = to_light(space, points[k]);
        if (!receivers.empty() && receivers[k] != kNoItem) {
            const Corners& own = triangles[receivers[k]];
            d = lifted(space, d, receiver_of(own, light_side(space, own, effort)));
        }
        bool found = false;
        for (std::size_t t = 0; t < triangles.size() && !found; ++t)
            found = (receivers.empty() || receivers[k] != t) &&
                    is_shadowed(space, triangles[t], d, effort);
        shadowed.push_back(found);
    }
    return shadowed;
}

struct Case {
    std::vector<glm::vec3> position;
    std::vector<glm::uvec3> index;
    std::vector<glm::vec3> points;
    std::vector<std::uint32_t> receivers;
};

/// Triangles of all sizes around the origin, and points in space and on the triangles.
Case random_case(std::mt19937& random, float size, bool snapped)
{
    std::uniform_real_distribution<float> unit(-1, 1);
    Case made;
    const auto somewhere = [&](float reach) {
        glm::vec3 p{unit(random), unit(random), unit(random)};
        if (snapped) p = glm::round(p * 4.0f) / 4.0f;
        return p * reach;
    };
    for (int t = 0; t < 120; ++t) {
        const float reach = size * std::exp2(-4.0f * std::abs(unit(random)));
        const glm::vec3 middle = somewhere(size);
        const auto first = std::uint32_t(made.position.size());
        for (int k = 0; k < 3; ++k) made.position.push_back(middle + somewhere(reach));
        made.index.push_back({first, first + 1, first + 2});
        if (t % 7 == 0) made.index.push_back({first + 1, first + 2, first}); // a duplicate
    }
    for (int k = 0; k < 3000; ++k) {
        if (k % 2) {
            made.points.push_back(somewhere(1.5f * size));
            made.receivers.push_back(kNoItem);
        } else {
            const auto t = std::uint32_t(random() % made.index.size());
            const glm::uvec3 c = made.index[t];
            float u = std::abs(unit(random)), v = std::abs(unit(random)) * (1 - u);
            if (snapped) u = 0.5f, v = 0.25f * float(random() % 3);
            made.points.push_back(
                (1 - u - v) * made.position[c.x] + u * made.position[c.y] + v * made.position[c.z]);
            made.receivers.push_back(t);
        }
    }
    return made;
}

void expect_brute(const Case& made, const Light& light, const std::string& what)
{
    const Scene scene = scene_from_arrays(made.position, made.index);
    World world;
    world.scene = borrow(scene);
    world.position = scene.position;
    const PencilSpace space = light_space(light, glm::dvec3(0));
    const auto expected = brute(world, space, made.points, made.receivers);
    for (const auto& [threads, plan] : {std::pair{1, ShadowPlan::cells}, {3, ShadowPlan::cells},
             {1, ShadowPlan::grid}, {3, ShadowPlan::grid}}) {
        ShadowMemory memory;
        memory.plan = plan;
        Tasks tasks(threads);
        std::vector<std::uint8_t> shadowed(made.points.size());
        PointSet set;
        make_point_set(made.points, made.receivers, threads > 1, set, tasks);
        test_points({world, space}, set, memory, tasks, shadowed);
        std::size_t wrong = 0;
        for (std::size_t k = 0; k < shadowed.size(); ++k) wrong += shadowed[k] != expected[k];
        EXPECT_EQ(wrong, 0u) << what << ", " << threads << " threads"
                             << (plan == ShadowPlan::grid ? ", grid" : ", cells");
    }
}

TEST(PointShadows, OfRandomTrianglesEqualBruteForce)
{
    for (const unsigned seed : {1u, 2u, 3u, 4u}) {
        for (const bool snapped : {false, true}) {
            for (const float size : {1e-3f, 1.0f, 1e6f}) {
                std::mt19937 random(seed);
                const Case made = random_case(random, size, snapped);
                const std::string what = "seed " + std::to_string(seed) + ", size " +
                                         std::to_string(size) + (snapped ? ", snapped" : "");
                Light light;
                light.position = glm::dvec3(0.1, 0.2, 0.05) * double(size);
                expect_brute(made, light, what + ", inside");
                light.position = glm::dvec3(2, 5, -1) * double(size);
                expect_brute(made, light, what + ", outside");
                light.position = glm::dvec3(made.position[4]);
                expect_brute(made, light, what + ", on a vertex");
                light.kind = Light::Kind::directional;
                light.direction = {0, -1, 0};
                expect_brute(made, light, what + ", from above");
                light.direction = {0.3, -1, 0.4};
                expect_brute(made, light, what + ", oblique");
            }
        }
    }
}

TEST(PointShadows, OfATriangleThatReachesBehindTheLightDoNotDependOnItsFirstCorner)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(-1, 1);
    Case made;
    for (int k = 0; k < 20000; ++k) made.points.push_back({unit(random), 0, unit(random)});
    // Needles across everything. Their boxes are larger, so that they are chosen as occluders.
    for (int k = 0; k < 100; ++k) {
        const float at = 0.01f * float(k);
        const auto first = std::uint32_t(made.position.size());
        made.position.insert(made.position.end(),
            {{-1 + at, 0.3f, -1}, {-0.999f + at, 0.3f, -1}, {1 - at, 0.3f, 1}});
        made.index.push_back({first, first + 1, first + 2});
    }
    // A triangle that reaches from below the light, which is at (0, 1, 0), to above it.
    const auto n = std::uint32_t(made.position.size());
    made.position.insert(made.position.end(), {{0, 0.5f, -0.3f}, {0, 0.5f, 0.3f}, {2, 3, 0}});
    Light light;
    light.position = {0, 1, 0};
    made.index.emplace_back();
    for (const glm::uvec3 corners :
        {glm::uvec3(0, 1, 2), glm::uvec3(1, 0, 2), glm::uvec3(2, 1, 0)}) {
        made.index.back() = corners + n;
        expect_brute(made, light, "corner " + std::to_string(corners.x) + " first");
    }
}

TEST(PointShadows, OfNeedlesThinnerThanRoundingErrorsEqualBruteForce)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<float> unit(-1, 1);
    Case made;
    Light light;
    light.position = {0.3, 3, 0.2};
    const glm::vec3 at(light.position);
    // Wide triangles, so that there are many cells, and so that these are chosen as occluders.
    for (int k = 0; k < 200; ++k) {
        const auto first = std::uint32_t(made.position.size());
        const float x = unit(random);
        made.position.insert(
            made.position.end(), {{x, -1.5f, -1}, {x + 1e-3f, -1.5f, -1}, {-x, -1.5f, 1}});
        made.index.push_back({first, first + 1, first + 2});
    }
    for (int k = 0; k < 40; ++k) {
        const glm::vec3 a{unit(random), 0.5f, -1}, b{unit(random), 0.6f, 1};
        const glm::vec3 c = a + 0.4f * (b - a) + glm::vec3(3e-8f * unit(random), 0, 0);
        const auto first = std::uint32_t(made.position.size());
        made.position.insert(made.position.end(), {a, b, c});
        made.index.push_back({first, first + 1, first + 2});
        for (int n = 0; n < 400; ++n)
            made.points.push_back(at + 1.4f * (a + std::abs(unit(random)) * (b - a) - at));
    }
    expect_brute(made, light, "needles");
}

} // namespace
} // namespace firsthit
