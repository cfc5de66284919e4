// tile_scene.h - scenes of a few triangles, and the hits of one tile.
//
// A simple ray caster in double precision finds the hits, so that only shading is tested.
#pragma once

#include "hits/hit_tile.h"
#include "scene/model/borrow.h"
#include "shade/shade_tile.h"

#include <firsthit/scene.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <variant>
#include <vector>

namespace firsthit {

struct TileScene {
    Scene scene;
    World world;
    HitTile hits;
    std::vector<HitRun> runs;
    alignas(64) std::uint32_t item[kMaxTile * kMaxTile];
    alignas(64) float t[kMaxTile * kMaxTile];
    alignas(64) float u[kMaxTile * kMaxTile];
    alignas(64) float v[kMaxTile * kMaxTile];

    /// A tile in the middle of the view. The eye is at 0 and looks along -z, y up.
    explicit TileScene(int size = 16, float f = 20.0f)
    {
        hits.size = size;
        const float first = 0.5f - static_cast<float>(size) / 2;
        hits.rays = {.step_x = 1.0f / f,
            .right = {1, 0, 0},
            .step_y = 1.0f / f,
            .down = {0, -1, 0},
            .x0 = first,
            .forward = {0, 0, -1},
            .y0 = first};
        scene.instances.emplace_back();
        scene.materials.emplace_back();
        scene.background = {0.25f, 0.5f, 0.75f};
    }
    TileScene(const TileScene&) = delete;

    Phong& material() { return std::get<Phong>(scene.materials[0].model); }

    /// Adds a material and an instance for the triangles that are added after this.
    template <class Model = Phong>
    Model& add_material()
    {
        scene.materials.emplace_back();
        scene.instances.emplace_back();
        scene.instances.back().material = static_cast<std::uint32_t>(scene.materials.size() - 1);
        return scene.materials.back().model.emplace<Model>();
    }

    /// Adds a triangle to the newest instance, with the normals of its plane.
    void add_triangle(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec2 uv_a = {},
        glm::vec2 uv_b = {}, glm::vec2 uv_c = {})
    {
        const std::uint32_t first = static_cast<std::uint32_t>(world.position.size());
        world.position.insert(world.position.end(), {a, b, c});
        const glm::vec3 n = glm::normalize(glm::cross(b - a, c - a));
        world.normal.insert(world.normal.end(), {n, n, n});
        scene.uv.insert(scene.uv.end(), {uv_a, uv_b, uv_c});
        scene.index.emplace_back(first, first + 1, first + 2);
        scene.owner.push_back(static_cast<std::uint32_t>(scene.instances.size() - 1));
        scene.vertices = world.position.size();
    }

    /// A square, counter-clockwise from its low left corner, with texture coordinates 0 to
    /// `repeats`.
    void add_square(glm::vec3 corner, glm::vec3 along_u, glm::vec3 along_v, float repeats = 1)
    {
        const float r = repeats;
        add_triangle(corner, corner + along_u, corner + along_u + along_v, {0, 0}, {r, 0}, {r, r});
        add_triangle(corner, corner + along_u + along_v, corner + along_v, {0, 0}, {r, r}, {0, r});
    }

    /// A square that fills the view at depth z, facing the eye.
    void add_wall(float z = 10, float half = 100, float repeats = 1)
    {
        add_square({-half, -half, -z}, {2 * half, 0, 0}, {0, 2 * half, 0}, repeats);
    }

    void add_light(glm::dvec3 position, glm::vec3 color = glm::vec3(1))
    {
        Light light;
        light.position = position;
        light.color = color;
        world.lights.push_back(light);
    }

    /// The direction of the ray of sample (x, y), with depth 1.
    glm::dvec3 direction(double x, double y) const
    {
        const Rays& rays = hits.rays;
        return glm::dvec3(rays.right) * ((rays.x0 + x) * rays.step_x) +
               glm::dvec3(rays.down) * ((rays.y0 + y) * rays.step_y) + glm::dvec3(rays.forward);
    }

    /// Depth and weights where the ray of (x, y) meets the plane of a triangle.
    glm::dvec3 meet(std::uint32_t triangle, double x, double y) const
    {
        const glm::uvec3 corner = scene.index[triangle];
        const glm::dvec3 d = direction(x, y);
        const glm::dvec3 p0(glm::dvec3(world.position[corner.x]) - glm::dvec3(hits.rays.eye));
        const glm::dvec3 e1 = glm::dvec3(world.position[corner.y] - world.position[corner.x]);
        const glm::dvec3 e2 = glm::dvec3(world.position[corner.z] - world.position[corner.x]);
        const double det = glm::dot(d, glm::cross(e1, e2));
        return {glm::dot(p0, glm::cross(e1, e2)) / det, glm::dot(d, glm::cross(e2, p0)) / det,
            glm::dot(d, glm::cross(p0, e1)) / det};
    }

    /// Fills the tile: the nearest triangle of each sample, runs of equal ones in each block.
    void cast()
    {
        world.scene = borrow(scene);
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint64_t> masks;
        for (int y = 0; y < hits.size; ++y)
            for (int x = 0; x < hits.size; ++x) {
                const std::size_t at = std::size_t(tile_offset(x, y, hits.size));
                item[at] = kNoItem;
                double nearest = std::numeric_limits<double>::infinity();
                // Samples without a hit get values that would show in the result if they were used.
                t[at] = u[at] = v[at] = std::numeric_limits<float>::quiet_NaN();
                for (std::uint32_t triangle = 0; triangle < scene.index.size(); ++triangle) {
                    const glm::dvec3 hit = meet(triangle, x, y);
                    const bool inside = hit.y >= 0 && hit.z >= 0 && hit.y + hit.z <= 1;
                    if (!inside || !(hit.x > 0) || !(hit.x < nearest)) continue;
                    nearest = hit.x;
                    item[at] = triangle;
                    t[at] = static_cast<float>(hit.x);
                    u[at] = static_cast<float>(hit.y);
                    v[at] = static_cast<float>(hit.z);
                }
                if (item[at] == kNoItem) continue;
                masks[{static_cast<std::uint32_t>(at / kBlockSamples), item[at]}] |=
                    std::uint64_t(1) << (at % kBlockSamples);
            }
        runs.clear();
        for (const auto& [key, mask] : masks)
            runs.push_back({key.second, static_cast<std::uint16_t>(key.first), 0, mask});
        point_at_arrays();
    }

    void point_at_arrays()
    {
        hits.item = item;
        hits.t = t;
        hits.u = u;
        hits.v = v;
        hits.runs = runs;
    }
};

/// All targets of a tile, with memory.
struct ShadeMemory {
    static constexpr int kPlanes = 22;
    static constexpr int kSamples = kMaxTile * kMaxTile;
    std::vector<float> value = std::vector<float>(kPlanes * kSamples + 16, -7.0f);
    ShadeTargets targets;

    ShadeMemory()
    {
        float* next = plane(0);
        for (float** list : {targets.color, targets.normal, targets.geometric_normal,
                 targets.position, targets.albedo, targets.emission})
            for (int axis = 0; axis < 3; ++axis, next += kSamples) list[axis] = next;
        for (float** list : {targets.uv, targets.metallic_roughness})
            for (int axis = 0; axis < 2; ++axis, next += kSamples) list[axis] = next;
    }
    ShadeMemory(const ShadeMemory&) = delete;

    /// Aligned to 64 bytes.
    float* plane(int number)
    {
        const std::size_t over = reinterpret_cast<std::uintptr_t>(value.data()) % 64;
        return value.data() + (64 - over) % 64 / sizeof(float) + number * kSamples;
    }
};

inline glm::vec3 at(float* const (&plane)[3], int x, int y, int size)
{
    const int k = tile_offset(x, y, size);
    return {plane[0][k], plane[1][k], plane[2][k]};
}

} // namespace firsthit
