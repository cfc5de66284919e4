// cast_files.h - rays from files, and what they hit into one.
#pragma once

#include <firsthit/ray_caster.h>

#include <cstdint>
#include <string>
#include <vector>

namespace firsthit::cli {

/// Where rays come from.
struct RayFiles {
    std::string rays;                // (N, 6); or the next two
    std::string origins, directions; // (N, 3), one of them perhaps (1, 3)
    std::string skip;                // (N); empty: none
    float t_min = 0, t_max = std::numeric_limits<float>::infinity();
};

/// throws  FileError: as read_npy_rays, read_npy_points, read_npy_ids; ArgumentError: numbers of rows that do not fit
std::vector<Ray> read_rays(const RayFiles& files);

/// Writes t, triangle, instance, uv and normal of each ray. owner: instances of triangles (Scene::owner)
void write_nearest(const std::string& path, const std::vector<RayHit>& hits,
    const std::vector<std::uint32_t>& owner);

/// Writes the same of all hits, and `first` (N + 1): those of ray k are first[k] to first[k + 1] - 1.
void write_all(
    const std::string& path, const RayHitLists& hits, const std::vector<std::uint32_t>& owner);

/// Writes `hit` of each ray.
void write_any(const std::string& path, const std::vector<std::uint8_t>& hit);

/// Writes `count` of each ray.
void write_count(const std::string& path, const std::vector<std::uint32_t>& count);

} // namespace firsthit::cli
