// errors.cpp - the library's exceptions as Python's.
#include "errors.h"

#include <firsthit/error.h>

#include <string>

namespace firsthit::python {
namespace {

namespace py = pybind11;

/// The kinds, which live as long as the module, that is, to the end of the process.
struct Kinds {
    PyObject *error, *file, *scene, *argument, *device, *cancelled;
};
Kinds kinds; // set once, when the module is imported

PyObject* make_kind(py::module_& module, const char* name, const char* text, const py::tuple& bases)
{
    const std::string full = std::string("firsthit.") + name;
    PyObject* kind = PyErr_NewExceptionWithDoc(full.c_str(), text, bases.ptr(), nullptr);
    if (!kind) throw py::error_already_set();
    module.add_object(name, py::reinterpret_borrow<py::object>(kind));
    return kind;
}

void translate(std::exception_ptr thrown)
{
    try {
        if (thrown) std::rethrow_exception(thrown);
    } catch (const FileError& e) {
        PyErr_SetString(kinds.file, e.what());
    } catch (const SceneError& e) {
        PyErr_SetString(kinds.scene, e.what());
    } catch (const ArgumentError& e) {
        PyErr_SetString(kinds.argument, e.what());
    } catch (const DeviceError& e) {
        PyErr_SetString(kinds.device, e.what());
    } catch (const Cancelled& e) {
        PyErr_SetString(kinds.cancelled, e.what());
    } catch (const Error& e) {
        PyErr_SetString(kinds.error, e.what());
    }
}

} // namespace

void add_errors(py::module_& module)
{
    const auto base = [](PyObject* kind) { return py::reinterpret_borrow<py::object>(kind); };
    kinds.error = make_kind(
        module, "Error", "What goes wrong in Firsthit.", py::make_tuple(base(PyExc_RuntimeError)));
    const py::object error = base(kinds.error);
    kinds.file =
        make_kind(module, "FileError", "A file cannot be read or written, or is malformed.",
            py::make_tuple(error, base(PyExc_OSError)));
    kinds.scene = make_kind(module, "SceneError",
        "A scene is not valid: an index out of range, a coordinate that is not finite.",
        py::make_tuple(error, base(PyExc_ValueError)));
    kinds.argument = make_kind(module, "ArgumentError", "An argument is out of range.",
        py::make_tuple(error, base(PyExc_ValueError)));
    kinds.device =
        make_kind(module, "DeviceError", "OpenGL is not there, or fails.", py::make_tuple(error));
    kinds.cancelled =
        make_kind(module, "Cancelled", "A frame was given up.", py::make_tuple(error));
    py::register_exception_translator(translate);
}

} // namespace firsthit::python
