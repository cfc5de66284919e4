// arrays.cpp - NumPy arrays, and what can be made one, as vectors.
#include "arrays.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>

namespace firsthit::python {
namespace {

namespace py = pybind11;

std::string shape_text(std::initializer_list<py::ssize_t> shape)
{
    std::ostringstream text;
    text << '(';
    const char* comma = "";
    for (const py::ssize_t length : shape) {
        text << comma;
        if (length == kAny)
            text << 'N';
        else
            text << length;
        comma = ", ";
    }
    text << (shape.size() == 1 ? ",)" : ")");
    return text.str();
}

/// What an array is: "float64 (3, 2)".
std::string what(const py::array& array)
{
    return std::string(py::str(array.dtype())) + " " + std::string(py::str(array.attr("shape")));
}

[[noreturn]] void refuse(const char* name, const std::string& got, const std::string& wanted)
{
    throw py::value_error(std::string(name) + ": got " + got + ", wanted " + wanted);
}

/// Whether an array lies in the buffer that it was made of, which NumPy does not ask where an object's
/// __array_interface__ names one.
bool lies_in_its_buffer(const py::array& array)
{
    const py::object base = array.base();
    if (!base || py::isinstance<py::array>(base) || !PyObject_CheckBuffer(base.ptr())) return true;
    Py_buffer buffer;
    if (PyObject_GetBuffer(base.ptr(), &buffer, PyBUF_SIMPLE) != 0) {
        PyErr_Clear(); // not in one piece: NumPy made the array of its strides
        return true;
    }
    const auto* const first = static_cast<const char*>(buffer.buf);
    const char* const end = first + buffer.len;
    PyBuffer_Release(&buffer);
    if (array.size() == 0) return true;
    const auto* low = static_cast<const char*>(array.data());
    const char* high = low + array.itemsize();
    for (py::ssize_t axis = 0; axis < array.ndim(); ++axis) {
        const py::ssize_t reach = (array.shape(axis) - 1) * array.strides(axis);
        (reach < 0 ? low : high) += reach;
    }
    return low >= first && high <= end;
}

/// As an array of numbers, of any type.
py::array any_array(const py::handle& object, const char* name, const std::string& wanted)
{
    const py::module_ numpy = py::module_::import("numpy");
    py::array array;
    try {
        const bool dlpack = py::hasattr(object, "__dlpack__") && !py::hasattr(object, "__array__");
        array = numpy.attr(dlpack ? "from_dlpack" : "asarray")(object);
    } catch (py::error_already_set& e) {
        if (!e.matches(PyExc_Exception)) throw; // the user's Ctrl-C
        throw py::type_error(
            std::string(name) + ": cannot be an array (" + e.what() + "), wanted " + wanted);
    }
    const char kind = array.dtype().kind();
    if (kind != 'f' && kind != 'i' && kind != 'u')
        throw py::type_error(
            std::string(name) + ": got " + what(array) + ", wanted numbers, " + wanted);
    if (!lies_in_its_buffer(array))
        throw py::value_error(
            std::string(name) + ": got " + what(array) + " of an object whose memory is smaller");
    return array;
}

void check_shape(const py::array& array, const char* name, std::initializer_list<py::ssize_t> shape,
    const std::string& wanted)
{
    bool fits = array.ndim() == py::ssize_t(shape.size());
    py::ssize_t axis = 0;
    for (const py::ssize_t length : shape) {
        fits = fits && (length == kAny || array.shape(axis) == length);
        ++axis;
    }
    if (!fits) refuse(name, what(array), wanted);
    constexpr py::ssize_t kMostRows = 0xFFFFFFFE; // ids are 32 bits; before anything is copied
    if (array.ndim() > 0 && array.shape(0) > kMostRows)
        refuse(name, what(array), wanted + ", at most " + std::to_string(kMostRows) + " of them");
}

/// In C order, native, of a type.
template <class T>
py::array_t<T> converted(const py::array& array)
{
    return py::array_t<T, py::array::c_style | py::array::forcecast>::ensure(array);
}

template <class T>
std::vector<T> vectors(const py::handle& object, const char* name)
{
    if (object.is_none()) return {};
    constexpr py::ssize_t columns = T::length();
    const py::array_t<float> array = float_array(object, name, {kAny, columns});
    std::vector<T> result(std::size_t(array.shape(0)));
    if (!result.empty()) std::memcpy(result.data(), array.data(), result.size() * sizeof(T));
    return result;
}

/// Whole numbers of a shape, from 0 to a largest value.
py::array_t<std::uint32_t> whole_numbers(const py::handle& object, const char* name,
    std::initializer_list<py::ssize_t> shape, std::uint32_t largest)
{
    const std::string wanted = "uint32 " + shape_text(shape);
    py::array array = any_array(object, name, wanted);
    if (array.dtype().kind() == 'f' && array.size() > 0)
        throw py::type_error(
            std::string(name) + ": got " + what(array) + ", wanted whole numbers, " + wanted);
    if (array.size() == 0 && array.ndim() == 1 && shape.size() == 2) // an empty list
        return py::array_t<std::uint32_t>(std::vector<py::ssize_t>{0, 3});
    check_shape(array, name, shape, wanted);
    if (array.size() == 0) return converted<std::uint32_t>(array);
    if (array.dtype().kind() == 'u' && array.itemsize() == 8) {
        const auto wide = converted<std::uint64_t>(array);
        for (py::ssize_t k = 0; k < wide.size(); ++k)
            if (wide.data()[k] > largest)
                refuse(name, std::to_string(wide.data()[k]),
                    "numbers up to " + std::to_string(largest));
    } else {
        const auto wide = converted<std::int64_t>(array);
        for (py::ssize_t k = 0; k < wide.size(); ++k)
            if (wide.data()[k] < 0 || wide.data()[k] > std::int64_t(largest))
                refuse(name, std::to_string(wide.data()[k]),
                    "numbers from 0 to " + std::to_string(largest));
    }
    return converted<std::uint32_t>(array);
}

float linear_of_srgb(float s)
{
    return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
}

} // namespace

py::array_t<float> float_array(
    const py::handle& object, const char* name, std::initializer_list<py::ssize_t> shape)
{
    const std::string wanted = "float32 " + shape_text(shape);
    py::array array = any_array(object, name, wanted);
    if (array.size() == 0 && array.ndim() == 1 && shape.size() == 2) // an empty list
        return py::array_t<float>(std::vector<py::ssize_t>{0, *(shape.begin() + 1)});
    check_shape(array, name, shape, wanted);
    return converted<float>(array);
}

std::vector<glm::vec3> vectors3(const py::handle& object, const char* name)
{
    return vectors<glm::vec3>(object, name);
}

std::vector<glm::vec2> vectors2(const py::handle& object, const char* name)
{
    return vectors<glm::vec2>(object, name);
}

std::vector<glm::vec4> colors4(const py::handle& object, const char* name)
{
    if (object.is_none()) return {};
    const std::string wanted = "(N, 3) or (N, 4), linear floats or sRGB from 0 to 255";
    const py::array given = any_array(object, name, wanted);
    if (given.ndim() != 2 || (given.shape(1) != 3 && given.shape(1) != 4))
        refuse(name, what(given), wanted);
    const bool bytes = given.dtype().kind() != 'f';
    const auto array = converted<float>(given);
    const auto columns = std::size_t(given.shape(1));
    std::vector<glm::vec4> colors(std::size_t(array.shape(0)), glm::vec4(1));
    const float* value = array.data();
    for (glm::vec4& color : colors)
        for (std::size_t k = 0; k < columns; ++k, ++value) {
            if (bytes && !(0 <= *value && *value <= 255))
                refuse(name, std::to_string(int(*value)), "whole numbers from 0 to 255");
            const float v = bytes ? *value / 255 : *value;
            color[int(k)] = bytes && k < 3 ? linear_of_srgb(v) : v;
        }
    return colors;
}

std::vector<glm::uvec3> triangles(const py::handle& object, const char* name)
{
    const auto array =
        whole_numbers(object, name, {kAny, 3}, std::numeric_limits<std::uint32_t>::max() - 1);
    std::vector<glm::uvec3> result(std::size_t(array.shape(0)));
    if (!result.empty())
        std::memcpy(result.data(), array.data(), result.size() * sizeof(glm::uvec3));
    return result;
}

std::vector<std::uint32_t> ids(const py::handle& object, const char* name)
{
    if (object.is_none()) return {};
    const auto array =
        whole_numbers(object, name, {kAny}, std::numeric_limits<std::uint32_t>::max());
    return {array.data(), array.data() + array.size()};
}

glm::dmat4 matrix4(const py::handle& object, const char* name)
{
    const std::string wanted = "float64 (4, 4)";
    const py::array given = any_array(object, name, wanted);
    check_shape(given, name, {4, 4}, wanted);
    const auto array = converted<double>(given);
    glm::dmat4 matrix;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            matrix[column][row] = array.data()[4 * row + column];
    return matrix;
}

glm::dvec3 vector3(const py::handle& object, const char* name)
{
    const std::string wanted = "three numbers";
    const py::array given = any_array(object, name, wanted);
    check_shape(given, name, {3}, wanted);
    const auto array = converted<double>(given);
    return {array.data()[0], array.data()[1], array.data()[2]};
}

py::array_t<double> to_array(const glm::dmat4& matrix)
{
    py::array_t<double> array({4, 4});
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            array.mutable_data()[4 * row + column] = matrix[column][row];
    return array;
}

py::array_t<double> to_array(const glm::dvec3& vector)
{
    py::array_t<double> array(3);
    for (int k = 0; k < 3; ++k) array.mutable_data()[k] = vector[k];
    return array;
}

} // namespace firsthit::python
