// arrays.h - NumPy arrays, and what can be made one, as vectors; memory of ours as arrays without a copy.
//
// Numbers of any type, byte order and layout are accepted and converted. Objects with __array__, __array_interface__,
// the buffer protocol or __dlpack__ are arrays, as are lists.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace firsthit::python {

/// Red, green and blue, linear.
using Color = std::array<float, 3>;

/// The colour as the library has it.
inline glm::vec3 to_vec3(const Color& color)
{
    return {color[0], color[1], color[2]};
}

/// A length of an array's shape that may be anything.
inline constexpr pybind11::ssize_t kAny = -1;

/// The array as float32, C order, with a shape.
/// name    of the argument, for messages
/// throws  TypeError, ValueError: they name the shape and type that were got and wanted
pybind11::array_t<float> float_array(const pybind11::handle& object, const char* name,
    std::initializer_list<pybind11::ssize_t> shape);

/// (N, 3) numbers; None or absent is empty.
std::vector<glm::vec3> vectors3(const pybind11::handle& object, const char* name);
/// (N, 2) numbers; None is empty.
std::vector<glm::vec2> vectors2(const pybind11::handle& object, const char* name);
/// (N, 3) or (N, 4) colours, of which a missing alpha is 1. Whole numbers are 0 to 255 and sRGB, others are linear. None
/// is empty.
std::vector<glm::vec4> colors4(const pybind11::handle& object, const char* name);
/// (N, 3) whole numbers from 0 to 2^32 - 2.
std::vector<glm::uvec3> triangles(const pybind11::handle& object, const char* name);
/// (N) whole numbers from 0 to 2^32 - 1; None is empty.
std::vector<std::uint32_t> ids(const pybind11::handle& object, const char* name);
/// A 4 x 4 matrix, rows first as in NumPy.
glm::dmat4 matrix4(const pybind11::handle& object, const char* name);
/// Three numbers.
glm::dvec3 vector3(const pybind11::handle& object, const char* name);

/// The matrix as an array (4, 4), rows first.
pybind11::array_t<double> to_array(const glm::dmat4& matrix);
/// The vector as an array (3).
pybind11::array_t<double> to_array(const glm::dvec3& vector);

/// An array over memory of ours, without a copy, that keeps `owner` alive.
template <class T>
pybind11::array_t<T> view_of(
    const T* data, std::vector<pybind11::ssize_t> shape, const pybind11::handle& owner)
{
    static const T nothing{}; // an array needs an address even where it has no elements
    return pybind11::array_t<T>(std::move(shape), data ? data : &nothing, owner);
}

/// Makes an array read-only.
template <class T>
pybind11::array_t<T> read_only(pybind11::array_t<T> array)
{
    pybind11::detail::array_proxy(array.ptr())->flags &=
        ~pybind11::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

} // namespace firsthit::python
