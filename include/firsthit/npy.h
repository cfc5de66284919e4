// npy.h - NumPy arrays in files: points and directions to read, answers to write.
#pragma once

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace firsthit {

/// Rows of three numbers, shape (N, 3), float32 or float64, rounded to the type that is asked for
/// (a float64 beyond the floats becomes infinite). Numbers that are not finite are kept.
/// throws  FileError that names the file, what it has and what is accepted: no NumPy file, another
///         type or shape, big endian, Fortran order, shorter or longer than its header says
std::vector<glm::vec3> read_npy_points(const std::string& path);

/// The same, rounded to double.
std::vector<glm::dvec3> read_npy_vectors(const std::string& path);

/// Shape (N), uint32, int32, uint64 or int64; values from 0 to 2^32 - 1, and -1 for kNoItem.
/// throws  as above; a value out of range, with its row
std::vector<std::uint32_t> read_npy_ids(const std::string& path);

/// As read_npy_points, from the bytes of a file; `name` stands in the messages.
std::vector<glm::vec3> parse_npy_points(std::string_view bytes, const std::string& name);
/// As read_npy_vectors, from bytes.
std::vector<glm::dvec3> parse_npy_vectors(std::string_view bytes, const std::string& name);
/// As read_npy_ids, from bytes.
std::vector<std::uint32_t> parse_npy_ids(std::string_view bytes, const std::string& name);

/// The shape of an array that is written: (rows, columns), or (columns).
struct NpyShape {
    std::size_t rows = 0;       // lines of the array
    std::size_t columns = 0;    // values in a row
    bool one_dimension = false; // (columns); rows is 1
};

/// Writes an array of uint8. Rows are asked for in turn and go to the file at once. The file
/// appears whole or not at all.
/// throws  FileError; and what fill_row throws
void write_npy_bytes(const std::string& path, const NpyShape& shape,
    const std::function<void(std::size_t row, std::span<std::uint8_t> values)>& fill_row);

} // namespace firsthit
