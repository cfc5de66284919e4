// read_npy.cpp - points, directions, rays and ids from NumPy files.
#include "io/whole_file.h"

#include <firsthit/npy.h>

namespace firsthit {
namespace {

constexpr std::uintmax_t kLargest = std::uintmax_t(1) << 36; // 2.8 billion points of doubles

} // namespace

std::vector<glm::vec3> read_npy_points(const std::string& path)
{
    return parse_npy_points(read_whole_file(path, kLargest), path);
}

std::vector<glm::dvec3> read_npy_vectors(const std::string& path)
{
    return parse_npy_vectors(read_whole_file(path, kLargest), path);
}

std::vector<std::array<float, 6>> read_npy_rays(const std::string& path)
{
    return parse_npy_rays(read_whole_file(path, kLargest), path);
}

std::vector<std::uint32_t> read_npy_ids(const std::string& path)
{
    return parse_npy_ids(read_whole_file(path, kLargest), path);
}

} // namespace firsthit
