// npy_parse.cpp - points, directions, rays and ids from NumPy arrays.
#include "io/npy_header.h"

#include <firsthit/error.h>
#include <firsthit/npy.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace firsthit {
namespace {

static_assert(std::endian::native == std::endian::little);

/// A float of 16 bits, as its bits.
struct Half {
    std::uint16_t bits;

    explicit operator double() const
    {
        const int exponent = bits >> 10 & 31;
        const double fraction = (bits & 1023) / 1024.0;
        double size = 0;
        if (exponent == 31)
            size = fraction == 0 ? std::numeric_limits<double>::infinity()
                                 : std::numeric_limits<double>::quiet_NaN();
        else if (exponent == 0)
            size = std::ldexp(fraction, -14);
        else
            size = std::ldexp(1 + fraction, exponent - 15);
        return bits & 0x8000 ? -size : size;
    }
    explicit operator float() const { return static_cast<float>(double(*this)); }
};

/// Calls f with a value of the type that descr names behind its byte order: "f4", "u2", "b1".
/// returns  false where it is none of those that are read
template <class F>
bool with_type(std::string_view type, const F& f)
{
    if (type == "f2") return f(Half{}), true;
    if (type == "f4") return f(float{}), true;
    if (type == "f8") return f(double{}), true;
    if (type == "i1") return f(std::int8_t{}), true;
    if (type == "i2") return f(std::int16_t{}), true;
    if (type == "i4") return f(std::int32_t{}), true;
    if (type == "i8") return f(std::int64_t{}), true;
    if (type == "u1" || type == "b1") return f(std::uint8_t{}), true;
    if (type == "u2") return f(std::uint16_t{}), true;
    if (type == "u4") return f(std::uint32_t{}), true;
    if (type == "u8") return f(std::uint64_t{}), true;
    return false;
}

/// What an array has to be.
struct Wanted {
    bool floats = false; // else whole numbers alone
    std::string_view type_names;
    std::size_t columns = 0; // 0: one dimension
};

constexpr Wanted kVectors{true, "float16, float32, float64, bool, and integers of 8 to 64 bits", 3};
constexpr Wanted kRays{true, kVectors.type_names, 6};
constexpr Wanted kIds{false, "bool, and integers of 8 to 64 bits", 0};

/// The array itself.
struct Array {
    std::string type; // "f4"
    bool big_endian = false;
    std::size_t rows = 0;
    std::size_t row_stride = 0, column_stride = 0; // values from one to the next
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
    const std::string type = descr.empty() ? "" : descr.substr(1);
    std::size_t size = 0;
    const bool known = with_type(type, [&](auto value) { size = sizeof(value); });
    const std::string_view orders = size == 1 ? "<=>|" : "<=>"; // a byte has none
    if (!known || orders.find(descr[0]) == std::string_view::npos ||
        (!wanted.floats && type[0] == 'f'))
        throw FileError(fmt::format(
            "{}: the type '{}' is not accepted, only {}", name, descr, wanted.type_names));

    const bool fits = wanted.columns == 0
                          ? header.shape.size() == 1
                          : header.shape.size() == 2 && header.shape[1] == wanted.columns;
    if (!fits)
        throw FileError(
            fmt::format("{}: the shape {} is not accepted, only {}", name, shape_text(header.shape),
                wanted.columns ? fmt::format("(N, {})", wanted.columns) : "(N,)"));
    const std::uint64_t rows = header.shape[0];
    const std::size_t columns = std::max<std::size_t>(1, wanted.columns);
    const std::uint64_t row_bytes = size * columns;
    const std::string_view data = bytes.substr(header.data_at);
    if (rows > data.size() / row_bytes || rows * row_bytes != data.size())
        throw FileError(fmt::format("{}: the shape {} does not fit the {} bytes that follow the "
                                    "header: {} bytes a row",
            name, shape_text(header.shape), data.size(), row_bytes));
    Array array{
        .type = type, .big_endian = descr[0] == '>', .rows = std::size_t(rows), .data = data};
    array.row_stride = header.fortran_order ? 1 : columns;
    array.column_stride = header.fortran_order ? array.rows : 1;
    return array;
}

template <class T>
T value_at(const Array& array, std::size_t row, std::size_t column)
{
    const std::size_t index = row * array.row_stride + column * array.column_stride;
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), array.data.data() + index * sizeof(T), sizeof(T));
    if (array.big_endian) std::reverse(raw.begin(), raw.end());
    return std::bit_cast<T>(raw);
}

/// Rows of numbers, each of a type with [].
template <class Row, class Number>
std::vector<Row> parse_rows(std::string_view bytes, const std::string& name, const Wanted& wanted)
{
    const Array array = parse(bytes, name, wanted);
    std::vector<Row> result(array.rows);
    with_type(array.type, [&](auto type) {
        for (std::size_t row = 0; row < array.rows; ++row)
            for (std::size_t k = 0; k < wanted.columns; ++k) {
                const auto value = value_at<decltype(type)>(array, row, k);
                if constexpr (std::is_same_v<Row, std::array<float, 6>>)
                    result[row][k] = static_cast<Number>(value);
                else
                    result[row][int(k)] = static_cast<Number>(value);
            }
    });
    return result;
}

/// One id; the message shows the value as NumPy prints it.
template <class T>
std::uint32_t id_of(T value, std::size_t row, const std::string& name)
{
    constexpr std::uint64_t kMost = 0xFFFFFFFF;
    if (std::is_signed_v<T> && value == static_cast<T>(-1)) return 0xFFFFFFFF;
    if (value < T(0) || static_cast<std::uint64_t>(value) > kMost)
        throw FileError(fmt::format("{}: row {}: {} is no id: accepted are 0 to 4294967295, "
                                    "and -1 for none",
            name, row, value));
    return static_cast<std::uint32_t>(value);
}

} // namespace

std::vector<glm::vec3> parse_npy_points(std::string_view bytes, const std::string& name)
{
    return parse_rows<glm::vec3, float>(bytes, name, kVectors);
}

std::vector<glm::dvec3> parse_npy_vectors(std::string_view bytes, const std::string& name)
{
    return parse_rows<glm::dvec3, double>(bytes, name, kVectors);
}

std::vector<std::array<float, 6>> parse_npy_rays(std::string_view bytes, const std::string& name)
{
    return parse_rows<std::array<float, 6>, float>(bytes, name, kRays);
}

std::vector<std::uint32_t> parse_npy_ids(std::string_view bytes, const std::string& name)
{
    const Array array = parse(bytes, name, kIds);
    std::vector<std::uint32_t> result(array.rows);
    with_type(array.type, [&](auto type) {
        if constexpr (std::is_integral_v<decltype(type)>)
            for (std::size_t row = 0; row < array.rows; ++row)
                result[row] = id_of(value_at<decltype(type)>(array, row, 0), row, name);
    });
    return result;
}

} // namespace firsthit
