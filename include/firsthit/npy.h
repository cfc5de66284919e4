// npy.h - reads and writes arrays in NumPy's file format.
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace firsthit {

/// Reads an array of shape (N, 3): float16, float32, float64, bool, or integers of 8 to 64 bits, of either
/// byte order, in C or Fortran order. Values are rounded once to float; those outside its range become
/// infinite. NaN and infinities are kept.
/// throws  FileError: not a NumPy file, another type or shape, or shorter or longer than its header says.
///         The message names the file, what it has, and what is accepted
std::vector<glm::vec3> read_npy_points(const std::string& path);

/// The same as doubles.
std::vector<glm::dvec3> read_npy_vectors(const std::string& path);

/// Reads an array of shape (N, 6), of the same types: origins and directions of rays.
/// throws  FileError: as read_npy_points
std::vector<std::array<float, 6>> read_npy_rays(const std::string& path);

/// Reads an array of shape (N), bool or integers of 8 to 64 bits of either byte order, with values from 0 to
/// 2^32 - 1; -1 means kNoItem.
/// throws  FileError: as read_npy_points, and for a value out of range (the message names its row)
std::vector<std::uint32_t> read_npy_ids(const std::string& path);

/// Like read_npy_points, for the bytes of a file that is in memory. `name` is used in error
/// messages.
std::vector<glm::vec3> parse_npy_points(std::string_view bytes, const std::string& name);
/// Like read_npy_vectors, for bytes in memory.
std::vector<glm::dvec3> parse_npy_vectors(std::string_view bytes, const std::string& name);
/// Like read_npy_rays, for bytes in memory.
std::vector<std::array<float, 6>> parse_npy_rays(std::string_view bytes, const std::string& name);
/// Like read_npy_ids, for bytes in memory.
std::vector<std::uint32_t> parse_npy_ids(std::string_view bytes, const std::string& name);

/// The shape of an array to write: (rows, columns), or (columns).
struct NpyShape {
    std::size_t rows = 0;       // number of rows
    std::size_t columns = 0;    // number of values in a row
    bool one_dimension = false; // the shape is (columns); rows must be 1
};

/// Writes an array of float32 of shape (N). The file appears whole or not at all.
/// throws  FileError: it cannot be written
void write_npy_floats(const std::string& path, std::span<const float> values);

/// Writes an array of uint8. The file appears whole or not at all.
/// fill_row  called for each row in order; fills in its values, which are written before the next
///           call
/// throws    FileError: it cannot be written; and what fill_row throws
void write_npy_bytes(const std::string& path, const NpyShape& shape,
    const std::function<void(std::size_t row, std::span<std::uint8_t> values)>& fill_row);

} // namespace firsthit
