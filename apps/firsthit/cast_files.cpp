// cast_files.cpp - rays from NumPy's files, and what they hit into one.
#include "cast_files.h"

#include <firsthit/error.h>
#include <firsthit/npy.h>
#include <firsthit/npz.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

namespace firsthit::cli {
namespace {

std::vector<Ray> read_pairs(const RayFiles& files)
{
    const std::vector<glm::vec3> origins = read_npy_points(files.origins),
                                 directions = read_npy_points(files.directions);
    const std::size_t count = origins.size() == 1 ? directions.size() : origins.size();
    if (directions.size() != count && directions.size() != 1)
        throw ArgumentError(fmt::format("{}: {} directions for the {} origins of {}: as many are "
                                        "accepted, or one of either",
            files.directions, directions.size(), origins.size(), files.origins));
    std::vector<Ray> rays(count);
    for (std::size_t k = 0; k < count; ++k) {
        rays[k].origin = origins[origins.size() == 1 ? 0 : k];
        rays[k].direction = directions[directions.size() == 1 ? 0 : k];
    }
    return rays;
}

template <class T>
NpzArray array_of(
    const char* name, const char* type, std::size_t columns, const std::vector<T>& values)
{
    std::vector<std::size_t> shape{values.size() / columns};
    if (columns > 1) shape.push_back(columns);
    return {name, type, shape, std::as_bytes(std::span(values))};
}

void write_hits(const std::string& path, const std::vector<RayHit>& hits,
    const std::vector<std::uint32_t>& owner, const std::vector<std::uint64_t>* first)
{
    std::vector<float> t, uv, normal;
    std::vector<std::uint32_t> triangle, instance;
    for (const RayHit& hit : hits) {
        t.push_back(hit.t);
        triangle.push_back(hit.triangle);
        instance.push_back(hit.triangle == kNoItem ? kNoItem : owner[hit.triangle]);
        uv.insert(uv.end(), {hit.u, hit.v});
        normal.insert(normal.end(), {hit.normal.x, hit.normal.y, hit.normal.z});
    }
    std::vector<NpzArray> arrays{array_of("t", "<f4", 1, t),
        array_of("triangle", "<u4", 1, triangle), array_of("instance", "<u4", 1, instance),
        array_of("uv", "<f4", 2, uv), array_of("normal", "<f4", 3, normal)};
    if (first) arrays.push_back(array_of("first", "<u8", 1, *first));
    write_npz(path, arrays);
}

} // namespace

std::vector<Ray> read_rays(const RayFiles& files)
{
    std::vector<Ray> rays;
    if (files.rays.empty()) {
        rays = read_pairs(files);
    } else {
        for (const std::array<float, 6>& r : read_npy_rays(files.rays))
            rays.push_back({{r[0], r[1], r[2]}, {r[3], r[4], r[5]}});
    }
    for (Ray& ray : rays) {
        ray.t_min = files.t_min;
        ray.t_max = files.t_max;
    }
    if (files.skip.empty()) return rays;
    const std::vector<std::uint32_t> skip = read_npy_ids(files.skip);
    if (skip.size() != rays.size())
        throw ArgumentError(fmt::format(
            "{}: {} triangles to skip for {} rays", files.skip, skip.size(), rays.size()));
    for (std::size_t k = 0; k < rays.size(); ++k) rays[k].skip = skip[k];
    return rays;
}

void write_nearest(const std::string& path, const std::vector<RayHit>& hits,
    const std::vector<std::uint32_t>& owner)
{
    write_hits(path, hits, owner, nullptr);
}

void write_all(
    const std::string& path, const RayHitLists& hits, const std::vector<std::uint32_t>& owner)
{
    const std::vector<std::uint64_t> first(hits.first.begin(), hits.first.end());
    write_hits(path, hits.hit, owner, &first);
}

void write_any(const std::string& path, const std::vector<std::uint8_t>& hit)
{
    const NpzArray array = array_of("hit", "|b1", 1, hit);
    write_npz(path, {&array, 1});
}

void write_count(const std::string& path, const std::vector<std::uint32_t>& count)
{
    const NpzArray array = array_of("count", "<u4", 1, count);
    write_npz(path, {&array, 1});
}

} // namespace firsthit::cli
