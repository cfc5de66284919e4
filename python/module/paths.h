// paths.h - paths of files: text, bytes or pathlib's.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace firsthit::python {

/// The path as the system has it. throws  TypeError: it is none
inline std::string path_text(const pybind11::handle& path)
{
    return pybind11::module_::import("os").attr("fsencode")(path).cast<std::string>();
}

} // namespace firsthit::python
