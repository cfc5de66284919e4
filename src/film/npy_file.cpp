// npy_file.cpp - writes NumPy arrays.
#include "io/npy_header.h"
#include "io/output_file.h"
#include "film/picture_files.h"

#include <firsthit/npy.h>

#include <fmt/format.h>

#include <bit>

namespace firsthit {

void write_npy(const PlaneView& plane, const std::string& path)
{
    static_assert(std::endian::native == std::endian::little);
    const bool items = !plane.item.empty();
    const std::string shape =
        plane.channels == 1
            ? fmt::format("({}, {})", plane.height, plane.width)
            : fmt::format("({}, {}, {})", plane.height, plane.width, plane.channels);
    const std::string header = npy_header(items ? "<u4" : "<f4", shape);
    OutputFile file(path);
    file.write(header.data(), header.size());
    if (items)
        file.write(plane.item.data(), plane.item.size_bytes());
    else
        file.write(plane.value.data(), plane.value.size_bytes());
    file.commit();
}

void write_npy_floats(const std::string& path, std::span<const float> values)
{
    const std::string header = npy_header("<f4", fmt::format("({},)", values.size()));
    OutputFile file(path);
    file.write(header.data(), header.size());
    file.write(values.data(), values.size_bytes());
    file.commit();
}

void write_npy_bytes(const std::string& path, const NpyShape& shape,
    const std::function<void(std::size_t row, std::span<std::uint8_t> values)>& fill_row)
{
    const std::string text = shape.one_dimension
                                 ? fmt::format("({},)", shape.columns)
                                 : fmt::format("({}, {})", shape.rows, shape.columns);
    const std::string header = npy_header("|u1", text);
    OutputFile file(path);
    file.write(header.data(), header.size());
    std::vector<std::uint8_t> values(shape.columns);
    for (std::size_t row = 0; row < shape.rows; ++row) {
        fill_row(row, values);
        file.write(values.data(), values.size());
    }
    file.commit();
}

} // namespace firsthit
