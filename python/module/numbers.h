// numbers.h - whole numbers of a range: whatever Python counts with, and clear errors for the rest.
#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <string>
#include <utility>

namespace firsthit::python {

/// The largest side of a picture that a camera can have.
inline constexpr int kMostPixels = 65536;
/// The most threads that may be asked for.
inline constexpr int kMostThreads = 1024;

/// A whole number, of Python or NumPy.
/// name    of the argument, for messages
/// throws  TypeError: it is none; ArgumentError: it is out of range. Both say what was got and what is accepted
int whole_number(
    const pybind11::handle& object, const std::string& name, std::int64_t least, int most);

/// A number of threads; 0: one for each core.
/// throws  as whole_number
int thread_count(const pybind11::handle& object);

/// (width, height) of a picture.
/// throws  TypeError, ArgumentError, as whole_number
std::pair<int, int> picture_size(const pybind11::handle& object);

} // namespace firsthit::python
