// brute_shadows.cpp - the oracle of shadows: tests every point against every triangle.
#include "rays/brute_shadows.h"

#include <firsthit/scene.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>

namespace firsthit {
namespace {

using glm::dvec3;
using glm::vec3;

constexpr std::size_t kSmallBlock = 64, kLargeBlock = 64 * kSmallBlock; // points

/// A shadow ray's direction, scaled so that its largest coordinate is 1. The scale does not change
/// which triangles are hit, but gives blocks of rays tight bounds. Each coordinate is within one
/// rounding.
dvec3 direction_of(const PencilSpace& space, const vec3& d)
{
    if (space.directional) return {d.x, d.y, 1};
    const dvec3 p(d), size = glm::abs(p);
    return p / std::max({size.x, size.y, size.z});
}

/// Sort keys that put points with similar rays next to each other: the face of a cube around the
/// light that the ray meets, then the interleaved bits of both coordinates on that face.
struct CoherentKeys {
    dvec3 low{std::numeric_limits<double>::infinity()}, high{-low}; // of the directional rays

    std::uint64_t operator()(const PencilSpace& space, const vec3& d) const
    {
        const dvec3 ray = direction_of(space, d);
        double u, v;
        std::uint64_t face = 0;
        if (space.directional) {
            u = (ray.x - low.x) / std::max(high.x - low.x, 1e-300);
            v = (ray.y - low.y) / std::max(high.y - low.y, 1e-300);
        } else {
            const dvec3 size = glm::abs(ray);
            const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
            face = std::uint64_t(2 * axis) + (ray[axis] < 0);
            u = 0.5 * (ray[(axis + 1) % 3] + 1);
            v = 0.5 * (ray[(axis + 2) % 3] + 1);
        }
        const auto bits = [](double x) { return std::uint64_t(std::clamp(x, 0.0, 1.0) * 0x1p20); };
        const std::uint64_t a = bits(u), b = bits(v);
        std::uint64_t key = face;
        for (int k = 20; k >= 0; --k) key = key << 2 | (a >> k & 1) << 1 | (b >> k & 1);
        return key;
    }
};

/// A triangle whose plane the light does not lie in.
struct ShadowTriangle {
    std::uint32_t id;
    std::array<dvec3, 3> edge; // edge . ray is positive inside; one rounding for each coordinate
    dvec3 normal;              // points away from the light
    dvec3 normal_size;         // the rounding errors of normal are relative to it
    dvec3 v0;
};

std::vector<ShadowTriangle> face(const PencilSpace& space, const LightTriangles& triangles)
{
    Effort effort;
    std::vector<ShadowTriangle> faced;
    for (std::size_t t = 0; t < triangles.index.size(); ++t) {
        const Corners c = triangles[t];
        const double facing = light_side(space, c, effort);
        if (facing == 0) continue;
        ShadowTriangle f{
            .id = std::uint32_t(t), .edge = {}, .normal = {}, .normal_size = {}, .v0 = dvec3(c[0])};
        const auto ray_space = [&](int k) {
            const vec3& p = c[std::size_t(k % 3)];
            return space.directional ? dvec3(p.x, p.y, 1) : dvec3(p);
        };
        const dvec3 e1 = dvec3(c[1]) - f.v0, e2 = dvec3(c[2]) - f.v0;
        for (int axis = 0; axis < 3; ++axis) {
            const int i = (axis + 1) % 3, j = (axis + 2) % 3;
            for (int k = 0; k < 3; ++k) {
                const dvec3 a = ray_space(k), b = ray_space(k + 1);
                f.edge[std::size_t(k)][axis] = facing * (a[i] * b[j] - a[j] * b[i]);
            }
            f.normal[axis] = facing * (e1[i] * e2[j] - e1[j] * e2[i]);
            f.normal_size[axis] = std::abs(e1[i] * e2[j]) + std::abs(e1[j] * e2[i]);
        }
        faced.push_back(f);
    }
    return faced;
}

/// Bounding boxes of some points and of the directions of their rays.
struct Block {
    dvec3 low{std::numeric_limits<double>::infinity()}, high{-low};
    dvec3 ray_low{low}, ray_high{high}, ray_size{0};

    void add(const PencilSpace& space, const vec3& d)
    {
        const dvec3 ray = direction_of(space, d);
        low = glm::min(low, dvec3(d)), high = glm::max(high, dvec3(d));
        ray_low = glm::min(ray_low, ray), ray_high = glm::max(ray_high, ray);
        ray_size = glm::max(ray_size, glm::abs(ray));
    }

    /// Whether the triangle certainly shadows no point of the block: the block is in front of its
    /// plane, or on the outer side of an edge. Each sum of three terms has at most nine roundings.
    bool is_missed_by(const ShadowTriangle& t) const
    {
        for (const dvec3& n : t.edge) {
            double most = 0, size = 0;
            for (int k = 0; k < 3; ++k) {
                most += std::max(n[k] * ray_low[k], n[k] * ray_high[k]);
                size += std::abs(n[k]) * ray_size[k];
            }
            if (most < -16 * kUlp * size) return true;
        }
        double most = 0, size = 0;
        for (int k = 0; k < 3; ++k) {
            const double a = low[k] - t.v0[k], b = high[k] - t.v0[k];
            most += std::max(t.normal[k] * a, t.normal[k] * b);
            size += t.normal_size[k] * std::max(std::abs(a), std::abs(b));
        }
        return most < -16 * kUlp * size;
    }
};

/// Whether the ray is certainly on the outer side of an edge.
bool is_outside(const ShadowTriangle& t, const dvec3& ray)
{
    for (const dvec3& n : t.edge) {
        const double x = n.x * ray.x, y = n.y * ray.y, z = n.z * ray.z;
        if ((x + y) + z < -16 * kUlp * (std::abs(x) + std::abs(y) + std::abs(z))) return true;
    }
    return false;
}

/// The input of all blocks, and the points in coherent order.
struct Query {
    const PencilSpace& space;
    const LightTriangles& triangles;
    std::span<const vec3> points;
    std::span<const std::uint32_t> receivers;
    std::vector<ShadowTriangle> faced;
    std::vector<std::uint32_t> order; // indices of the points that have a shadow ray

    std::span<const std::uint32_t> slice(std::size_t first, std::size_t count) const
    {
        return std::span(order).subspan(first, std::min(count, order.size() - first));
    }

    Block block_of(std::span<const std::uint32_t> members) const
    {
        Block block;
        for (const std::uint32_t k : members) block.add(space, points[k]);
        return block;
    }

    bool is_shadowed_by(
        std::uint32_t point, const ShadowTriangle& t, const dvec3& ray, Effort& effort) const
    {
        if (!receivers.empty() && receivers[point] == t.id) return false;
        return !is_outside(t, ray) && triangles.shadows(space, t.id, points[point], effort);
    }
};

Query prepare(const PencilSpace& space, const LightTriangles& triangles,
    std::span<const vec3> points, std::span<const std::uint32_t> receivers)
{
    Query query{space, triangles, points, receivers, face(space, triangles), {}};
    CoherentKeys keys;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed;
    for (const vec3& d : points) {
        if (!has_shadow_ray(space, d)) continue;
        keys.low = glm::min(keys.low, dvec3(d)), keys.high = glm::max(keys.high, dvec3(d));
    }
    for (std::size_t k = 0; k < points.size(); ++k)
        if (has_shadow_ray(space, points[k]))
            keyed.push_back({keys(space, points[k]), std::uint32_t(k)});
    std::sort(keyed.begin(), keyed.end());
    for (const auto& [key, point] : keyed) query.order.push_back(point);
    return query;
}

/// Tests the points of a large block. Finds the triangles that may shadow the large block; of
/// these, for each small block, those that may shadow it; and tests its points against them.
void test_large_block(
    const Query& query, std::span<const std::uint32_t> members, std::span<std::uint8_t> shadowed)
{
    Effort effort;
    const Block large = query.block_of(members);
    std::vector<const ShadowTriangle*> candidates;
    for (const ShadowTriangle& t : query.faced)
        if (!large.is_missed_by(t)) candidates.push_back(&t);
    for (std::size_t first = 0; first < members.size(); first += kSmallBlock) {
        const auto some = members.subspan(first, std::min(kSmallBlock, members.size() - first));
        const Block small = query.block_of(some);
        for (const ShadowTriangle* t : candidates) {
            if (small.is_missed_by(*t)) continue;
            for (const std::uint32_t point : some)
                if (!shadowed[point])
                    shadowed[point] = query.is_shadowed_by(
                        point, *t, direction_of(query.space, query.points[point]), effort);
        }
    }
}

} // namespace

std::vector<vec3> all_to_light(const PencilSpace& space, std::span<const vec3> points)
{
    std::vector<vec3> result;
    result.reserve(points.size());
    for (const vec3& p : points) result.push_back(to_light(space, p));
    return result;
}

bool is_shadowed_brute(const PencilSpace& space, const LightTriangles& triangles, const vec3& d,
    std::uint32_t receiver, Effort& effort)
{
    for (std::size_t t = 0; t < triangles.index.size(); ++t)
        if (t != receiver && triangles.shadows(space, t, d, effort)) return true;
    return false;
}

void brute_shadows(const PencilSpace& space, const LightTriangles& triangles,
    std::span<const vec3> points, std::span<const std::uint32_t> receivers,
    std::span<std::uint8_t> shadowed, Tasks& tasks, const std::function<void(double)>& progress)
{
    std::fill(shadowed.begin(), shadowed.end(), std::uint8_t(0));
    const Query query = prepare(space, triangles, points, receivers);
    const std::size_t blocks = (query.order.size() + kLargeBlock - 1) / kLargeBlock;
    std::atomic<std::size_t> done{0};
    tasks.for_each(blocks, [&](std::size_t block, std::size_t worker) {
        test_large_block(query, query.slice(block * kLargeBlock, kLargeBlock), shadowed);
        const std::size_t now = ++done;
        if (progress && worker == 0) progress(double(now) / double(blocks));
    });
}

} // namespace firsthit
