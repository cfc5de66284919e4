// sky_light.cpp - the light of the sky that arrives at points.
#include "render/check_settings.h"
#include "shadow/sky/sky_rays.h"

#include <firsthit/error.h>
#include <firsthit/sky.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>

namespace firsthit {
namespace {

/// Whether a direction is on the side of the receiver's plane that the normal is on. True without receiver.
bool is_before_receiver(const World& world, std::uint32_t receiver, const glm::vec3& normal,
    const glm::dvec3& direction)
{
    if (receiver == kNoItem) return true;
    const glm::uvec3& corner = world.scene->index[receiver];
    const glm::dvec3 a(world.position[corner.x]), b(world.position[corner.y]),
        c(world.position[corner.z]);
    const glm::dvec3 n = glm::cross(b - a, c - a);
    return (glm::dot(n, direction) > 0) == (glm::dot(n, glm::dvec3(normal)) > 0);
}

} // namespace

std::vector<glm::dvec3> sky_directions(int count, const glm::dvec3& up)
{
    check_sky_directions(count);
    std::vector<glm::dvec3> directions;
    fill_sky_directions(count, zenith_of({.up = up}, up), directions);
    return directions;
}

void sky_light(Occlusion& occlusion, const World& world, const Sky& sky, const SkyPoints& points,
    std::vector<glm::vec3>& light)
{
    check_sky(sky);
    const std::size_t count = points.positions.size();
    if (points.normals.size() != count)
        throw ArgumentError(fmt::format(
            "{} normals for {} points: one for each is accepted", points.normals.size(), count));
    light.assign(count, glm::vec3(0));
    if (sky.directions == 0) return;
    const glm::dvec3 zenith = zenith_of(sky, sky.up);
    const std::vector<glm::dvec3> directions = sky_directions(sky.directions, zenith);
    SkyRays rays;
    set_up_sky(sky, zenith, directions, rays);
    std::vector<Light> lights;
    for (const glm::dvec3& w : directions) lights.push_back(sky_ray_light(w));
    std::vector<float> open(count, 0.0f), seen(count, 0.0f);
    occlusion.test(
        world, points.positions, lights,
        [&](std::size_t k, std::span<const std::uint8_t> occluded) {
            for (std::size_t p = 0; p < count; ++p) {
                const glm::vec3& n = points.normals[p];
                const float cosine =
                    std::max((n.x * rays.x[k] + n.y * rays.y[k]) + n.z * rays.z[k], 0.0f);
                open[p] += cosine;
                if (occluded[p] || cosine <= 0) continue;
                if (points.receivers.empty() ||
                    is_before_receiver(world, points.receivers[p], n, directions[k]))
                    seen[p] += cosine;
            }
        },
        points.receivers);
    for (std::size_t p = 0; p < count; ++p) {
        const SkyShares shares =
            sky_shares(rays, open[p], seen[p], glm::dot(points.normals[p], rays.up));
        light[p] = rays.color * shares.sky + rays.ground * shares.ground;
    }
}

} // namespace firsthit
