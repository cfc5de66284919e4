// npz.h - writes several named arrays into one file, as numpy.load reads it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace firsthit {

/// An array of a file. Its values are in C order and of this machine, which is little endian.
struct NpzArray {
    std::string name;                // as numpy.load(file)[name]
    std::string type;                // NumPy's: "<f4", "<u4", "<u8", "|u1", "|b1"
    std::vector<std::size_t> shape;  // rows first
    std::span<const std::byte> data; // of all values
};

/// Writes a .npz file: a ZIP archive of NumPy arrays, not compressed, the same bytes for the same arrays. It appears whole
/// or not at all.
/// throws  FileError: it cannot be written, or would be larger than 4 GiB, which such an archive cannot be
///         ArgumentError: data whose size is not that of shape and type
void write_npz(const std::string& path, std::span<const NpzArray> arrays);

} // namespace firsthit
