// scenes.cpp - scenes from files: what is in them, and their poses.
#include "arrays.h"
#include "bindings.h"
#include "interpreter.h"
#include "paths.h"
#include "posed.h"

#include <firsthit/scene.h>
#include <firsthit/studio.h>

#include <pybind11/stl.h>

#include <cmath>
#include <optional>
#include <string>

namespace firsthit::python {
namespace {

namespace py = pybind11;

std::string accepted_clips(const Scene& scene)
{
    std::string text;
    for (const Clip& clip : scene.clips) text += (text.empty() ? "" : ", ") + clip.name;
    return text.empty() ? "it has none" : text;
}

/// A clip by name or number, or None: the first; "none" is the pose at rest.
std::int32_t clip_of(const Scene& scene, const py::object& clip, std::int32_t usual)
{
    if (clip.is_none()) return usual;
    if (py::isinstance<py::str>(clip)) {
        const auto name = clip.cast<std::string>();
        if (name == "none") return PoseSettings::kRest;
        for (std::size_t k = 0; k < scene.clips.size(); ++k)
            if (scene.clips[k].name == name) return std::int32_t(k);
        throw py::value_error("clip: there is no '" + name + "': " + accepted_clips(scene));
    }
    const auto number = clip.cast<std::int64_t>();
    if (number < 0 || number >= std::int64_t(scene.clips.size()))
        throw py::value_error("clip: there is no number " + std::to_string(number) + " of " +
                              std::to_string(scene.clips.size()) + ": " + accepted_clips(scene));
    return std::int32_t(number);
}

LoadedScene load(const py::object& given_path, const py::object& clip, std::optional<bool> studio,
    const std::string& scene, bool strict, double crease_angle,
    const std::optional<Color>& background)
{
    const std::string path = path_text(given_path);
    LoadSettings settings;
    settings.scene = scene;
    settings.strict = strict;
    settings.crease_angle_rad = crease_angle * std::acos(-1.0) / 180;
    LoadedScene loaded;
    {
        const Unlocked unlocked;
        Scene read = load_scene(path, settings);
        loaded.studio = studio.value_or(!has_own_lights(read));
        if (loaded.studio) set_up_studio(read);
        if (background) read.background = to_vec3(*background);
        loaded.scene = std::make_shared<const Scene>(std::move(read));
    }
    loaded.clip = clip_of(*loaded.scene, clip, 0);
    return loaded;
}

py::list clips(const LoadedScene& self)
{
    py::list all;
    for (const Clip& clip : self.scene->clips) {
        py::dict entry;
        entry["name"] = clip.name;
        entry["begin"] = clip.begin_s;
        entry["end"] = clip.end_s;
        entry["frames"] = clip.frames;
        all.append(entry);
    }
    return all;
}

py::list instances(const LoadedScene& self)
{
    const Scene& scene = *self.scene;
    py::list all;
    for (const Instance& instance : scene.instances) {
        py::dict entry;
        entry["name"] = instance.name;
        entry["node"] = instance.node;
        entry["material"] = instance.material;
        entry["first_vertex"] = instance.first_vertex;
        entry["vertex_count"] = instance.vertex_count;
        entry["first_triangle"] = instance.first_triangle;
        entry["triangle_count"] = instance.triangle_count;
        all.append(entry);
    }
    return all;
}

template <class T>
py::list names(const std::vector<T>& things)
{
    py::list all;
    for (const T& thing : things) all.append(thing.name);
    return all;
}

} // namespace

void add_scenes(py::module_& module)
{
    py::class_<LoadedScene>(module, "Scene", "A scene as it was read or built. It does not change.")
        .def_property_readonly("name", [](const LoadedScene& self) { return self.scene->name; })
        .def_property_readonly(
            "vertex_count", [](const LoadedScene& self) { return self.scene->vertex_count(); })
        .def_property_readonly(
            "triangle_count", [](const LoadedScene& self) { return self.scene->triangle_count(); })
        .def_property_readonly("triangles",
            [](const py::object& self) {
                const auto& index = self.cast<const LoadedScene&>().scene->index;
                return read_only(view_of(
                    index.empty() ? nullptr : &index[0].x, {py::ssize_t(index.size()), 3}, self));
            })
        .def_property_readonly("triangle_instances",
            [](const py::object& self) {
                const auto& owner = self.cast<const LoadedScene&>().scene->owner;
                return read_only(view_of(owner.data(), {py::ssize_t(owner.size())}, self));
            })
        .def_property_readonly("uv",
            [](const py::object& self) -> py::object {
                const auto& uv = self.cast<const LoadedScene&>().scene->uv;
                if (uv.empty()) return py::none();
                return read_only(view_of(&uv[0].x, {py::ssize_t(uv.size()), 2}, self));
            })
        .def_property_readonly("clips", &clips)
        .def_property_readonly("instances", &instances)
        .def_property_readonly(
            "materials", [](const LoadedScene& self) { return names(self.scene->materials); })
        .def_property_readonly(
            "nodes", [](const LoadedScene& self) { return names(self.scene->nodes); })
        .def_property_readonly(
            "cameras", [](const LoadedScene& self) { return names(self.scene->cameras); })
        .def_property_readonly(
            "warnings", [](const LoadedScene& self) { return self.scene->warnings; })
        .def_property_readonly("files", [](const LoadedScene& self) { return self.scene->files; })
        .def_readonly("studio", &LoadedScene::studio)
        .def_property_readonly("background",
            [](const LoadedScene& self) {
                const glm::vec3& c = self.scene->background;
                return Color{c.x, c.y, c.z};
            })
        .def_property_readonly("clip",
            [](const LoadedScene& self) -> py::object {
                if (!self.scene->has_clip(self.clip)) return py::none();
                return py::int_(self.clip);
            })
        .def_property_readonly(
            "begin", [](const LoadedScene& self) { return self.scene->begin_s(self.clip); })
        .def_property_readonly(
            "end", [](const LoadedScene& self) { return self.scene->end_s(self.clip); })
        .def("_clip_number",
            [](const LoadedScene& self, const py::object& clip) {
                return clip_of(*self.scene, clip, self.clip);
            })
        .def("__repr__", [](const LoadedScene& self) {
            return "<firsthit.Scene '" + self.scene->name + "', " +
                   std::to_string(self.scene->triangle_count()) + " triangles>";
        });
    module.def("load", &load, py::arg("path"), py::kw_only(), py::arg("clip") = py::none(),
        py::arg("studio") = py::none(), py::arg("scene") = "", py::arg("strict") = false,
        py::arg("crease_angle") = 30.0, py::arg("background") = py::none());
}

} // namespace firsthit::python
