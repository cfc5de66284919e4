// bindings.h - the parts of the module, each in a file of its own.
#pragma once

#include <pybind11/pybind11.h>

namespace firsthit::python {

void add_scenes(pybind11::module_& module);    // Scene, load
void add_builder(pybind11::module_& module);   // Material, SceneBuilder
void add_worlds(pybind11::module_& module);    // World
void add_lights(pybind11::module_& module);    // Light, Sky, where the sun is
void add_cameras(pybind11::module_& module);   // Camera, files of cameras, framing
void add_frames(pybind11::module_& module);    // Settings, Frame, Renderer
void add_occlusion(pybind11::module_& module); // points and lights
void add_rays(pybind11::module_& module);      // any rays
void add_compare(pybind11::module_& module);   // our items against others'

} // namespace firsthit::python
