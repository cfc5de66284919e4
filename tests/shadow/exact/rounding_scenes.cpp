// rounding_scenes.cpp - triangles and lights whose shadows depend on the last bits.
#include "shadow/shadow_builder.h"

#include <glm/geometric.hpp>

namespace firsthit::test {
namespace {

using glm::dvec3;
using glm::vec3;

/// A point with many significant bits, but the sum of two such points is exact in float.
vec3 fine_point(std::mt19937& random)
{
    return vec3(whole(random, -4000000, 4000000), whole(random, -4000000, 4000000),
               whole(random, -4000000, 4000000)) *
           0x1p-21f;
}

void lights_inside_triangles(Builder& b)
{
    // a + b + c = 0: the plane goes exactly through the origin, even if doubles round the volume.
    for (int k = 0; k < 6; ++k) {
        const vec3 p = fine_point(b.random), q = fine_point(b.random);
        b.triangle(p, q, -(p + q));
        b.triangle(0.5f * p, -0.5f * (p + q), 0.5f * q);
    }
    b.box(vec3(-3), vec3(3));
    b.light(point_light({0, 0, 0}));
    b.light(spot_light({0, 0, 0}, {0.3, -1, 0.2}, 1.4));
    b.eye({1.5, 2, 2.5});
}

void corners_next_to_a_light(Builder& b)
{
    // Planes so near to the light that the slopes of depth overflow float.
    const auto tiny = [&] {
        return random_point(b.random, std::pow(10.0f, uniform(b.random, -44, -30)));
    };
    for (int k = 0; k < 40; ++k) {
        const vec3 p = random_point(b.random), q = random_point(b.random);
        b.triangle(p, q, k % 2 ? tiny() : -p * uniform(b.random, 0, 2) + tiny());
    }
    b.box(vec3(-3), vec3(3));
    b.light(point_light({0, 0, 0}));
    b.light(point_light({0, 1e-40, 0}));
    b.eye({1.5, 2, 2.5});
}

void small_and_far_away(Builder& b)
{
    b.floor(-1);
    for (int k = 0; k < 300; ++k) {
        const vec3 p = random_point(b.random);
        b.triangle(p + random_point(b.random, 0.1f), p + random_point(b.random, 0.1f),
            p + random_point(b.random, 0.1f));
    }
    b.light(directional_light({0.3, -1, 0.4}));
    b.light(directional_light({0, -1, 0}));
    b.light(point_light({0.5, 3, 0.25}));
    b.eye({1, 2, 3});
    transform(b.made, 1, {72237, 70488, -139953});
}

} // namespace

void add_rounding(Scenes& scenes)
{
    add(scenes, "lights exactly inside triangles", lights_inside_triangles);
    add(scenes, "corners next to a light", corners_next_to_a_light);
    add(scenes, "small and far away", small_and_far_away);
    for (const float scale : {1e-34f, 1e-36f, 1e-39f, 1e-40f})
        add(scenes, "a ball on a floor at scale 1e" + std::to_string(int(std::log10(scale))),
            [scale](Builder& b) {
                b.floor();
                b.sphere({0, 0.5f, 0}, 0.5f, 12);
                b.light(point_light({1.7, 2.3, 1.1}));
                b.light(directional_light({-1, -1.5, 0.5}));
                b.eye({2, 3, 4});
                transform(b.made, scale, vec3(0));
            });
    add(scenes, "lights out of reach", [](Builder& b) {
        b.floor();
        b.sphere({0, 0.5f, 0}, 0.5f, 12);
        b.light(point_light({1e6, 2e6, 1e6}));    // beyond 1e30
        b.light(point_light({1e14, 2e14, 1e14})); // infinite as floats
        b.light(point_light({1.7, 2.3, 1.1}));
        b.eye({2, 3, 4});
        transform(b.made, 1e25f, vec3(0));
    });
}

} // namespace firsthit::test
