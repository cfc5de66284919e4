// npy_parse.cpp - points, directions and ids from NumPy arrays.
#include "io/npy_header.h"

#include <firsthit/error.h>
#include <firsthit/npy.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

namespace firsthit {
namespace {

static_assert(std::endian::native == std::endian::little);

/// What an array has to be.
struct Wanted {
    std::string_view types; // of descr, without the byte order: "f4 f8"
    std::string_view type_names;
    std::size_t columns = 0; // 0: one dimension
};

constexpr Wanted kVectors{"f4 f8", "float32 and float64", 3};
constexpr Wanted kIds{"u4 i4 u8 i8", "uint32, int32, uint64 and int64", 0};

/// The array itself.
struct Array {
    std::string type; // "f4"
    std::size_t rows = 0;
    std::string_view data;
};

std::string shape_text(const std::vector<std::uint64_t>& shape)
{
    return shape.size() == 1 ? fmt::format("({},)", shape[0])
                             : fmt::format("({})", fmt::join(shape, ", "));
}

Array parse(std::string_view bytes, const std::string& name, const Wanted& wanted)
{
    const NpyHeader header = parse_npy_header(bytes, name);
    const std::string& descr = header.descr;
    const std::string type = descr.size() == 3 ? descr.substr(1) : "";
    if (descr.size() == 3 && descr[0] == '>')
        throw FileError(fmt::format("{}: the type '{}' is big endian: accepted is little endian, "
                                    "as of array.astype('<{}')",
            name, descr, type));
    const bool known = type.size() == 2 && type.find(' ') == std::string::npos &&
                       wanted.types.find(type) != std::string_view::npos;
    if (!known || (descr[0] != '<' && descr[0] != '='))
        throw FileError(fmt::format(
            "{}: the type '{}' is not accepted, only {}", name, descr, wanted.type_names));

    const bool fits = wanted.columns == 0
                          ? header.shape.size() == 1
                          : header.shape.size() == 2 && header.shape[1] == wanted.columns;
    if (!fits)
        throw FileError(fmt::format("{}: the shape {} is not accepted, only {}", name,
            shape_text(header.shape), wanted.columns ? "(N, 3)" : "(N,)"));
    const std::uint64_t rows = header.shape[0];
    if (header.fortran_order && wanted.columns > 1 && rows > 1)
        throw FileError(fmt::format("{}: the array is in Fortran order: accepted is C order, as of "
                                    "numpy.ascontiguousarray",
            name));

    const std::uint64_t row_bytes =
        std::uint64_t(type[1] - '0') * std::max<std::size_t>(1, wanted.columns);
    const std::string_view data = bytes.substr(header.data_at);
    if (rows > data.size() / row_bytes || rows * row_bytes != data.size())
        throw FileError(fmt::format("{}: the shape {} does not fit the {} bytes that follow the "
                                    "header: {} bytes a row",
            name, shape_text(header.shape), data.size(), row_bytes));
    return {type, std::size_t(rows), data};
}

template <class T>
T number_at(std::string_view data, std::size_t index)
{
    T value;
    std::memcpy(&value, data.data() + index * sizeof(T), sizeof(T));
    return value;
}

template <class Vector>
std::vector<Vector> parse_rows(std::string_view bytes, const std::string& name)
{
    const Array array = parse(bytes, name, kVectors);
    std::vector<Vector> result(array.rows);
    for (std::size_t row = 0; row < array.rows; ++row) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double value = array.type == "f4"
                                     ? double(number_at<float>(array.data, 3 * row + k))
                                     : number_at<double>(array.data, 3 * row + k);
            result[row][int(k)] = static_cast<typename Vector::value_type>(value);
        }
    }
    return result;
}

/// A value of the array as NumPy prints it: negative values of unsigned types do not exist.
std::int64_t id_at(const Array& array, std::size_t row, const std::string& name)
{
    if (array.type == "u4") return number_at<std::uint32_t>(array.data, row);
    if (array.type == "i4") return number_at<std::int32_t>(array.data, row);
    if (array.type == "i8") return number_at<std::int64_t>(array.data, row);
    const auto value = number_at<std::uint64_t>(array.data, row);
    if (value > std::uint64_t(std::numeric_limits<std::int64_t>::max()))
        throw FileError(
            fmt::format("{}: row {}: {} is no id: accepted are 0 to 4294967295", name, row, value));
    return std::int64_t(value);
}

} // namespace

std::vector<glm::vec3> parse_npy_points(std::string_view bytes, const std::string& name)
{
    return parse_rows<glm::vec3>(bytes, name);
}

std::vector<glm::dvec3> parse_npy_vectors(std::string_view bytes, const std::string& name)
{
    return parse_rows<glm::dvec3>(bytes, name);
}

std::vector<std::uint32_t> parse_npy_ids(std::string_view bytes, const std::string& name)
{
    const Array array = parse(bytes, name, kIds);
    std::vector<std::uint32_t> result(array.rows);
    for (std::size_t row = 0; row < array.rows; ++row) {
        const std::int64_t value = id_at(array, row, name);
        if (value < -1 || value > std::int64_t(0xFFFFFFFF))
            throw FileError(fmt::format("{}: row {}: {} is no id: accepted are 0 to 4294967295, "
                                        "and -1 for none",
                name, row, value));
        result[row] = static_cast<std::uint32_t>(value);
    }
    return result;
}

} // namespace firsthit
