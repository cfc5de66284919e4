// shadow_margin_test.cpp - rounding lets no surface shadow itself, and close surfaces still cast
// shadows.
#include "exact/pencil.h"
#include "exact/shadow_ray.h"
#include "hits/hit_position.h"
#include "scene/model/borrow.h"
#include "scenes.h"

#include <firsthit/firsthit.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace firsthit::test {
namespace {

using glm::dvec3;
using glm::vec3;

struct Mesh {
    std::vector<vec3> position;
    std::vector<glm::uvec3> index;

    void sphere(const dvec3& middle, double radius, int n)
    {
        const auto first = std::uint32_t(position.size()), columns = std::uint32_t(2 * n);
        for (int j = 0; j <= n; ++j) {
            for (int i = 0; i < 2 * n; ++i) {
                const double a = std::numbers::pi * i / n, b = std::numbers::pi * j / n;
                const double ring = j % n == 0 ? 0 : std::sin(b);
                position.push_back(vec3(
                    middle + radius * dvec3(ring * std::cos(a), std::cos(b), ring * std::sin(a))));
            }
        }
        for (std::uint32_t j = 0; j < std::uint32_t(n); ++j) {
            for (std::uint32_t i = 0; i < columns; ++i) {
                const auto at = [&](std::uint32_t x, std::uint32_t y) {
                    return first + (j + y) * columns + (i + x) % columns;
                };
                index.push_back({at(0, 0), at(1, 0), at(1, 1)});
                index.push_back({at(0, 0), at(1, 1), at(0, 1)});
            }
        }
    }
};

struct LitPicture {
    Scene scene;
    World world;
    Film film;

    LitPicture(const Mesh& mesh, const std::vector<Light>& lights, const View& view)
        : scene(scene_from_arrays(mesh.position, mesh.index))
    {
        scene.lights = lights;
        pose(borrow(scene), 0, world);
        Settings settings;
        settings.color = false;
        settings.aovs = {Aov::item, Aov::position, Aov::lit};
        Renderer(2).render(world, view, settings, film);
    }

    /// The number of hits that are dark although their triangle faces the light.
    std::size_t dark_though_facing(std::size_t light) const
    {
        const Light& l = world.lights[light];
        std::size_t dark = 0;
        for (std::size_t k = 0; k < film.item.size(); ++k) {
            if (film.item[k] == kNoItem) continue;
            const glm::uvec3 c = scene.index[film.item[k]];
            const dvec3 a(world.position[c.x]), b(world.position[c.y]), e(world.position[c.z]);
            const float* p = &film[Aov::position].value[3 * k];
            const dvec3 hit(p[0], p[1], p[2]);
            const dvec3 way = l.kind == Light::Kind::directional ? -l.direction : l.position - a;
            dvec3 n = glm::normalize(glm::cross(b - a, e - a));
            if (glm::dot(n, world.camera.eye - a) < 0) n = -n;
            // If the light is nearer to the plane than this, rounding of the corners decides its
            // side.
            const double longest =
                             std::max({glm::length(b - a), glm::length(e - b), glm::length(a - e)}),
                         height = glm::length(glm::cross(b - a, e - a)) / longest;
            const double slack = 0x1p-21 * (glm::length(hit) + glm::length(l.position)) / height;
            if (glm::dot(n, glm::normalize(way)) < 1e-5 + slack) continue;
            dark += film[Aov::lit].value[k * world.lights.size() + light] == 0;
        }
        return dark;
    }
};

View view_from(const dvec3& eye, const dvec3& at, double fov_y_rad)
{
    View view;
    view.width = view.height = 160;
    view.camera.eye = eye;
    view.camera.direction = at - eye;
    view.camera.fov_y_rad = fov_y_rad;
    return view;
}

Light directional(const dvec3& direction)
{
    Light light;
    light.kind = Light::Kind::directional;
    light.direction = direction;
    return light;
}

Light point(const dvec3& position)
{
    Light light;
    light.position = position;
    return light;
}

/// Random hits, half of them where the errors can be largest: at a corner of the picture, with the
/// eye and the hit, which is near the light, opposite each other around the origin. Their exact
/// positions are computed in double. The depth is off by at most a unit in the last place, as that
/// of hits.
TEST(ShadowMargin, ExceedsTheRoundingErrorsOfHits)
{
    std::mt19937_64 random(7);
    const auto in = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const auto vector = [&] { return dvec3(in(-1, 1), in(-1, 1), in(-1, 1)); };
    const auto largest = [](const dvec3& v) {
        return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    };
    double most = 0;
    for (int k = 0; k < 300000; ++k) {
        const bool bad = k % 2 == 0;
        const double size = std::floor(in(64, 4096));
        View view;
        view.camera.direction = vector();
        view.camera.up = vector();
        view.camera.fov_y_rad = in(0.3, 2.2);
        view.width = view.height = int(size);
        Pencil pencil = pencil_of(view, {0, 0, view.width, view.height}, 1);
        const int x = bad ? 0 : int(in(0, size)), y = bad ? 0 : int(in(0, size));
        const dvec3 ray = pencil.world_from_axes *
                          dvec3((pencil.x0 + x) / pencil.f.x, (pencil.y0 + y) / pencil.f.y, 1);
        const double t = std::exp2(in(-6, 6));
        pencil.eye = bad ? -0.5 * t * ray * in(0.9, 1.1) : vector() * std::exp2(in(-10, 10));
        const dvec3 exact = pencil.eye + t * ray;
        const float nearest = float(t), towards = double(nearest) < t ? INFINITY : 0.0f;
        const float depth = k % 3 == 0 ? nearest : std::nextafter(nearest, towards);
        const vec3 p =
            hit_position(world_rays(pencil, pencil.tile(0, 0)), float(x), float(y), depth);
        Light light;
        light.kind = k % 4 < 2 ? Light::Kind::point : Light::Kind::directional;
        light.position = dvec3(vec3(exact + vector() * (t * std::exp2(in(-12, 5)))));
        light.direction = vector();
        const PencilSpace space = light_space(light, pencil.eye);
        const vec3 d = to_light(space, p);
        const dvec3 d_exact = space.directional ? space.axes * exact : exact - dvec3(space.origin);
        most = std::max(most, largest(dvec3(d) - d_exact) / double(shadow_margin(space, d)));
    }
    EXPECT_LT(most, 1);
    EXPECT_GT(most, 0.3) << "the positions are not the bad ones any more";
}

TEST(ShadowMargin, AConvexMeshHasNoDarkSpotsAtAnyScaleAndPlace)
{
    for (const double scale : {1e-3, 1.0, 1e6}) {
        for (const double offset : {0.0, 10.0, 1000.0}) {
            for (const double distance : {0.5, 3.0, 30.0}) {
                std::mt19937 random(unsigned(10 * distance + offset));
                std::normal_distribution<double> normal;
                const auto way = [&] {
                    return glm::normalize(dvec3(normal(random), normal(random), normal(random)));
                };
                const dvec3 middle = offset * scale * dvec3(1, 0.7, -0.3);
                Mesh mesh;
                mesh.sphere(middle, scale, 64);
                const dvec3 eye = middle + way() * scale * (1 + distance);
                LitPicture picture(mesh,
                    {point(middle + way() * scale * 1.5), point(middle + way() * scale * 40.0),
                        directional(way()), directional(way())},
                    view_from(eye, middle, distance > 10 ? 0.07 : 0.6));
                picture.world.camera.eye = eye;
                for (std::size_t light = 0; light < 4; ++light)
                    EXPECT_EQ(picture.dark_though_facing(light), 0u)
                        << "scale " << scale << ", offset " << offset << ", distance " << distance
                        << ", light " << light;
            }
        }
    }
}

TEST(ShadowMargin, LargeCoplanarFloorsStayLit)
{
    for (const double scale : {1e-3, 1.0, 1e6}) {
        for (const double near : {0.1, 1.0, 10.0}) {
            const auto floor = [&](double x, double z) {
                return vec3(scale * dvec3(x, 0.31 * x - 0.17 * z, z));
            };
            Mesh mesh;
            mesh.position = {
                floor(-900, -900), floor(900, -900), floor(900, 900), floor(-900, 900)};
            mesh.index = {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}};
            const dvec3 eye = scale * dvec3(0.1, near, 0.2);
            LitPicture picture(mesh,
                {point(scale * dvec3(-0.2, 1.5 * near, 0.3)), directional({0.4, -1, 0.3})},
                view_from(eye, scale * dvec3(0.3 * near, 0, 0), 1));
            picture.world.camera.eye = eye;
            for (std::size_t light = 0; light < 2; ++light)
                EXPECT_EQ(picture.dark_though_facing(light), 0u)
                    << "scale " << scale << ", near " << near << ", light " << light;
        }
    }
}

/// Two balls one above the other, the light in the upper one's middle: the share of the lower one's
/// top that the upper one shadows.
double shadowed_share(double gap)
{
    Mesh mesh;
    mesh.sphere({0, -1, 0}, 1, 96);
    mesh.sphere({0, 1 + gap, 0}, 1, 96);
    const Scene scene = scene_from_arrays(mesh.position, mesh.index);
    World world;
    pose(borrow(scene), 0, world);
    // On the triangles around the lower ball's top, beside it: where the balls are closest.
    std::vector<vec3> points;
    std::vector<std::uint32_t> receivers;
    for (std::uint32_t t = 0; t < 2 * 192; ++t) {
        const glm::uvec3 c = scene.index[t];
        const vec3 a = world.position[c.x], b = world.position[c.y], e = world.position[c.z];
        if (a == b || b == e || e == a) continue;
        points.push_back(0.999f * a + 0.0005f * (b + e));
        receivers.push_back(t);
    }
    std::vector<std::uint8_t> occluded;
    std::size_t dark = 0;
    Occlusion(1).test(world, points, point({0, 1, 0}), occluded, receivers);
    for (const std::uint8_t byte : occluded) dark += byte;
    return double(dark) / double(points.size());
}

TEST(ShadowMargin, BallsThatNearlyTouchShadowOneAnother)
{
    EXPECT_EQ(shadowed_share(1e-3), 1);
    EXPECT_EQ(shadowed_share(4e-5), 1);
    EXPECT_EQ(shadowed_share(5e-6), 1) << "five millionths of the distance to the light";
    EXPECT_EQ(shadowed_share(0), 0) << "balls in touch do not: the margins are not for nothing";
}

} // namespace
} // namespace firsthit::test
