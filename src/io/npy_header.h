// npy_header.h - the text before a NumPy array.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace firsthit {

struct NpyHeader {
    std::string descr; // as "<f4"
    bool fortran_order = false;
    std::vector<std::uint64_t> shape;
    std::size_t data_at = 0; // bytes before the array
};

/// Reads format 1.0, 2.0 and 3.0: a dictionary of exactly the three keys, in any order.
/// name    stands in the messages
/// throws  FileError that says what is wrong with it
NpyHeader parse_npy_header(std::string_view bytes, const std::string& name);

/// Format 1.0, little endian, C order; the array starts at a multiple of 64.
/// shape  as "(3, 4)"
std::string npy_header(const std::string& descr, const std::string& shape);

} // namespace firsthit
