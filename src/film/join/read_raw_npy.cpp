// read_raw_npy.cpp - a NumPy array's values as its file holds them.
#include "film/join/raw_picture.h"

#include "io/npy_header.h"
#include "io/whole_file.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace firsthit {
namespace {

/// Of "<f4", "|u1" and so on; 0: something else.
std::size_t value_bytes(const std::string& type)
{
    if (type.size() != 3 || type[2] < '1' || type[2] > '8') return 0;
    return static_cast<std::size_t>(type[2] - '0');
}

} // namespace

RawPicture read_raw_npy(const std::string& path, const glm::ivec2& size)
{
    const std::string bytes = read_whole_file(path);
    const NpyHeader header = parse_npy_header(bytes, path);
    const std::size_t dimensions = header.shape.size(), one = value_bytes(header.descr);
    if (header.fortran_order || (dimensions != 2 && dimensions != 3) || one == 0)
        throw FileError(fmt::format("{}: accepted are arrays of shape (height, width) and (height, "
                                    "width, values) of numbers, in C order",
            path));
    constexpr std::uint64_t kMost = 65536;
    if (header.shape[0] > kMost || header.shape[1] > kMost ||
        (dimensions == 3 && header.shape[2] > kMost))
        throw FileError(fmt::format("{}: a side above {}", path, kMost));
    RawPicture picture;
    picture.height = static_cast<int>(header.shape[0]);
    picture.width = static_cast<int>(header.shape[1]);
    check_raw_size(path, {picture.width, picture.height}, size);
    const std::size_t values = dimensions == 3 ? static_cast<std::size_t>(header.shape[2]) : 0;
    picture.kind = RawNpy{header.descr, values};
    picture.pixel_bytes = one * (dimensions == 3 ? values : 1);
    const std::size_t expected = picture.pixel_bytes * static_cast<std::size_t>(picture.width) *
                                 static_cast<std::size_t>(picture.height);
    if (bytes.size() - header.data_at != expected)
        throw FileError(fmt::format("{}: {} bytes of values, and its header says {}", path,
            bytes.size() - header.data_at, expected));
    picture.bytes.assign(bytes.begin() + static_cast<std::ptrdiff_t>(header.data_at), bytes.end());
    return picture;
}

} // namespace firsthit
