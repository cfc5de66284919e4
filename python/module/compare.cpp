// compare.cpp - our items and shadows against brute force and Embree.
#include "bindings.h"
#include "interpreter.h"
#include "camera.h"
#include "numbers.h"
#include "posed.h"

#include <firsthit/compare.h>

#include <string>

namespace firsthit::python {
namespace {

namespace py = pybind11;

Oracle oracle_named(const std::string& name)
{
    if (name == "brute") return Oracle::brute;
    if (name == "embree") return Oracle::embree;
    throw py::value_error("against: '" + name + "' is none: accepted are brute and embree");
}

py::dict compare_items(PosedWorld& world, const SizedCamera& camera, const std::string& against,
    bool lit, const py::object& given_threads)
{
    const int threads = thread_count(given_threads);
    const Oracle oracle = oracle_named(against);
    Comparison items;
    LitComparison light;
    {
        const Unlocked unlocked;
        const std::shared_lock lock(world.use);
        items = compare(world.world, camera.view, oracle, threads);
        if (lit) light = compare_lit(world.world, camera.view, oracle, threads);
    }
    py::dict all;
    all["pixels"] = items.pixels;
    all["agree"] = items.agree;
    all["ties"] = items.ties;
    all["ours_wrong"] = items.ours_wrong;
    all["theirs_wrong"] = items.theirs_wrong;
    if (lit) {
        all["lit_values"] = light.pixels;
        all["lit_agree"] = light.agree;
        all["lit_ours_wrong"] = light.ours_wrong;
        all["lit_theirs_wrong"] = light.theirs_wrong;
    }
    return all;
}

} // namespace

void add_compare(py::module_& module)
{
    module.def("compare", &compare_items, py::arg("world"), py::arg("camera"), py::kw_only(),
        py::arg("against") = "brute", py::arg("lit") = false, py::arg("threads") = 0);
}

} // namespace firsthit::python
