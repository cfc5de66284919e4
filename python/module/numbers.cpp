// numbers.cpp - whole numbers of a range: whatever Python counts with, and clear errors for the rest.
#include "numbers.h"

#include <firsthit/error.h>

namespace firsthit::python {

namespace py = pybind11;

int whole_number(const py::handle& object, const std::string& name, std::int64_t least, int most)
{
    const std::string accepted =
        "accepted are whole numbers from " + std::to_string(least) + " to " + std::to_string(most);
    const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(object.ptr()));
    if (!index) {
        PyErr_Clear();
        throw py::type_error(name + ": got " + std::string(py::repr(object)) + ": " + accepted);
    }
    int overflow = 0;
    const long long value = PyLong_AsLongLongAndOverflow(index.ptr(), &overflow);
    if (overflow != 0 || value < least || value > most)
        throw ArgumentError(
            name + ": " + std::string(py::str(index)) + " is out of range: " + accepted);
    return int(value);
}

int thread_count(const py::handle& object)
{
    return whole_number(object, "threads", 0, kMostThreads);
}

std::pair<int, int> picture_size(const py::handle& object)
{
    if (!py::isinstance<py::sequence>(object) || py::isinstance<py::str>(object) ||
        py::len(object) != 2)
        throw py::type_error("size: got " + std::string(py::repr(object)) +
                             ": accepted is (width, height), in pixels");
    const auto sides = py::reinterpret_borrow<py::sequence>(object);
    return {whole_number(sides[0], "size: width", 1, kMostPixels),
        whole_number(sides[1], "size: height", 1, kMostPixels)};
}

} // namespace firsthit::python
