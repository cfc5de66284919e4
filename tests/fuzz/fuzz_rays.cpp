// fuzz_rays.cpp - rays and triangles of any bits, as floats: the tree says what a loop over all triangles says, before and
// after the corners move.
#include "exact/ray_hit.h"
#include "rays/tree/cast_rays.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace {

using namespace firsthit;

/// What is nearest by a loop, and how many triangles are hit.
struct LoopAnswer {
    std::uint32_t nearest = kNoItem, count = 0;
};

LoopAnswer loop(const WorldTriangles& triangles, const Ray& ray)
{
    LoopAnswer answer;
    if (!usable(ray)) return answer;
    Effort effort;
    const auto corners = [&](std::uint32_t t) -> Corners {
        const glm::uvec3& c = triangles.index[t];
        return {triangles.position[c.x], triangles.position[c.y], triangles.position[c.z]};
    };
    for (std::uint32_t t = 0; t < triangles.index.size(); ++t) {
        const Corners c = corners(t);
        if (t == ray.skip || !is_hit(ray, c, effort) ||
            compare_depth(ray, c, ray.t_min, effort) < 0 ||
            compare_depth(ray, c, ray.t_max, effort) > 0)
            continue;
        ++answer.count;
        if (answer.nearest == kNoItem || compare_depth(ray, c, corners(answer.nearest), effort) < 0)
            answer.nearest = t;
    }
    return answer;
}

void check(const CastTarget& target, const WorldTriangles& triangles, const std::vector<Ray>& rays)
{
    std::vector<RayHit> hits(rays.size()), all;
    std::vector<std::uint8_t> any(rays.size());
    std::vector<std::uint32_t> count(rays.size()), all_count(rays.size());
    cast_nearest(target, rays, hits);
    cast_any(target, rays, any);
    cast_count(target, rays, count);
    cast_all(target, rays, all_count, all);
    for (std::size_t k = 0; k < rays.size(); ++k) {
        const LoopAnswer wanted = loop(triangles, rays[k]);
        if (hits[k].triangle != wanted.nearest || count[k] != wanted.count ||
            all_count[k] != wanted.count || (any[k] != 0) != (wanted.count > 0))
            std::abort();
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    // The first half are corners, the second rays; all corners are in the triangles twice.
    std::vector<float> number(std::min<std::size_t>(size / 4, 400));
    if (!number.empty()) std::memcpy(number.data(), data, 4 * number.size());
    std::vector<glm::vec3> position;
    const std::size_t half = number.size() / 2;
    for (std::size_t k = 0; k + 3 <= half; k += 3)
        position.push_back({number[k], number[k + 1], number[k + 2]});
    std::vector<glm::uvec3> index;
    for (unsigned k = 0; k + 2 < position.size(); ++k) index.push_back({k, k + 1, k + 2});
    std::vector<Ray> rays;
    for (std::size_t k = half; k + 8 <= number.size(); k += 8) {
        const float* n = &number[k];
        rays.push_back({{n[0], n[1], n[2]}, {n[3], n[4], n[5]}});
        rays.push_back({{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, n[6], n[7], unsigned(k % 5)});
        if (!position.empty()) // through a corner
            rays.push_back(
                {{n[0], n[1], n[2]}, position[k % position.size()] - glm::vec3(n[0], n[1], n[2])});
    }
    static Tasks tasks(1);
    const Scene scene;
    const Cutouts cutouts;
    RayTree tree;
    tree.build({position, index}, tasks);
    check({tree, scene, cutouts}, {position, index}, rays);
    std::reverse(position.begin(), position.end());
    tree.refit({position, index}, tasks);
    check({tree, scene, cutouts}, {position, index}, rays);
    return 0;
}
