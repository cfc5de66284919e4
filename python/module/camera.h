// camera.h - a camera with the size of its picture, as Python holds it.
#pragma once

#include <firsthit/view.h>

#include <string>

namespace firsthit::python {

/// A camera, its picture's size, and a name where a file gave it one.
struct SizedCamera {
    View view; // without a region
    std::string name;
};

} // namespace firsthit::python
