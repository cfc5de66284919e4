// errors.h - the library's exceptions as Python's.
#pragma once

#include <pybind11/pybind11.h>

namespace firsthit::python {

/// Makes firsthit.Error and its kinds, and has every exception of the library raised as one of them. ArgumentError
/// is also a ValueError, FileError an OSError.
void add_errors(pybind11::module_& module);

} // namespace firsthit::python
