// module.cpp - the module firsthit._firsthit, on which the package stands.
#include "bindings.h"
#include "errors.h"
#include "interpreter.h"

#include <firsthit/render.h>

PYBIND11_MODULE(_firsthit, module)
{
    using namespace firsthit::python;
    module.doc() = "The compiled part of firsthit: see the package.";
    add_errors(module);
    add_ending(module);
    add_lights(module);
    add_scenes(module);
    add_builder(module);
    add_worlds(module);
    add_cameras(module);
    add_frames(module);
    add_occlusion(module);
    add_rays(module);
    add_compare(module);
    module.attr("__version__") = firsthit::version();
    module.def("instruction_set", &firsthit::instruction_set);
}
