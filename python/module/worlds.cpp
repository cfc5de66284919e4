// worlds.cpp - scenes at a time, whose vertices Python may move.
#include "arrays.h"
#include "bindings.h"
#include "interpreter.h"
#include "numbers.h"
#include "posed.h"

#include <firsthit/error.h>
#include <firsthit/framing.h>
#include <firsthit/normals.h>

#include <pybind11/stl.h>

#include <cmath>
#include <limits>
#include <mutex>
#include <span>
#include <string>

namespace firsthit::python {
namespace {

namespace py = pybind11;

py::array_t<float> vertex_view(std::vector<glm::vec3>& vectors, const py::object& owner)
{
    return view_of(
        vectors.empty() ? nullptr : &vectors[0].x, {py::ssize_t(vectors.size()), 3}, owner);
}

/// Poses it anew; its arrays keep their addresses, because a scene's sizes do not change.
void pose_world(PosedWorld& self, double time_s, std::int32_t clip, const py::object& given_camera,
    const py::object& given_threads)
{
    const int threads = thread_count(given_threads);
    const std::int32_t camera =
        whole_number(given_camera, "camera", 0, std::numeric_limits<std::int32_t>::max());
    const Unlocked unlocked;
    const std::unique_lock lock(self.use);
    pose(
        self.source.scene, {.time_s = time_s, .clip = clip, .camera = camera}, self.world, threads);
}

/// Sums x * 0, which is 0 for finite x, so that the good case runs without branches.
bool all_finite(std::span<const glm::vec3> vectors)
{
    glm::vec3 sum(0);
    for (const glm::vec3& v : vectors) sum += v * 0.0f;
    return sum == glm::vec3(0);
}

/// throws  SceneError: a coordinate that is not finite
void check_positions(PosedWorld& self)
{
    const Unlocked unlocked;
    const std::shared_lock lock(self.use);
    const auto& position = self.world.position;
    if (all_finite(position)) return;
    for (std::size_t k = 0; k < position.size(); ++k)
        if (!(std::isfinite(position[k].x) && std::isfinite(position[k].y) &&
                std::isfinite(position[k].z)))
            throw SceneError("positions: vertex " + std::to_string(k) + " is not finite");
}

} // namespace

void add_worlds(py::module_& module)
{
    py::class_<PosedWorld>(module, "World", "A scene at one time, in world space.")
        .def_property_readonly("positions",
            [](const py::object& self) {
                return vertex_view(self.cast<PosedWorld&>().world.position, self);
            })
        .def_property_readonly("normals",
            [](const py::object& self) {
                return vertex_view(self.cast<PosedWorld&>().world.normal, self);
            })
        .def_property_readonly("time", [](const PosedWorld& self) { return self.world.time_s; })
        .def_property_readonly("scene", [](const PosedWorld& self) { return self.source; })
        .def_property_readonly("bounds",
            [](const PosedWorld& self) {
                const auto box = bounds(self.world);
                return py::make_tuple(to_array(glm::dvec3(box[0])), to_array(glm::dvec3(box[1])));
            })
        .def_property_readonly(
            "lights", [](const PosedWorld& self) { return std::vector<Light>(self.world.lights); })
        .def("changed", &check_positions)
        .def(
            "update_normals",
            [](PosedWorld& self, const py::object& given_threads) {
                const int threads = thread_count(given_threads);
                const Unlocked unlocked;
                const std::unique_lock lock(self.use);
                update_normals(self.world, threads);
            },
            py::arg("threads") = 1)
        .def("_pose", &pose_world)
        .def(
            "node_matrix",
            [](const PosedWorld& self, std::size_t node) {
                if (node >= self.world.node_matrix.size())
                    throw py::index_error("there is no node " + std::to_string(node) + " of " +
                                          std::to_string(self.world.node_matrix.size()));
                return to_array(self.world.node_matrix[node]);
            },
            py::arg("node"))
        .def("__repr__", [](const PosedWorld& self) {
            return "<firsthit.World of '" + self.source.scene->name + "' at " +
                   std::to_string(self.world.time_s) + " s>";
        });
    module.def("_same_scene", [](const PosedWorld& world, const LoadedScene& scene) {
        return world.source.scene == scene.scene;
    });
    module.def("_new_world", [](const LoadedScene& scene) {
        auto world = std::make_unique<PosedWorld>();
        world->source = scene;
        return world;
    });
}

} // namespace firsthit::python
