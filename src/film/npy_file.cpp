// npy_file.cpp - writes NumPy arrays.
#include "film/output_file.h"
#include "film/picture_files.h"

#include <fmt/format.h>

#include <bit>

namespace firsthit {

void write_npy(const PlaneView& plane, const std::string& path)
{
    // source  NumPy Enhancement Proposal 1, "A Simple File Format for NumPy Arrays"
    static_assert(std::endian::native == std::endian::little);
    const bool items = !plane.item.empty();
    const std::string shape =
        plane.channels == 1
            ? fmt::format("({}, {})", plane.height, plane.width)
            : fmt::format("({}, {}, {})", plane.height, plane.width, plane.channels);
    std::string header = fmt::format(
        "{{'descr': '{}', 'fortran_order': False, 'shape': {}, }}", items ? "<u4" : "<f4", shape);

    // Magic, version and length are 10 bytes; the data starts at a multiple of 64, after a newline.
    const std::size_t length = (10 + header.size() + 1 + 63) / 64 * 64 - 10;
    header.resize(length - 1, ' ');
    header += '\n';
    const std::string start = {'\x93', 'N', 'U', 'M', 'P', 'Y', 1, 0,
        static_cast<char>(length & 0xFF), static_cast<char>(length >> 8)};

    OutputFile file(path);
    file.write(start.data(), start.size());
    file.write(header.data(), header.size());
    if (items)
        file.write(plane.item.data(), plane.item.size_bytes());
    else
        file.write(plane.value.data(), plane.value.size_bytes());
    file.commit();
}

} // namespace firsthit
