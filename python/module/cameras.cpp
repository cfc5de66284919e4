// cameras.cpp - cameras by numbers, of files, and such as show all of a world.
#include "camera.h"

#include "arrays.h"
#include "bindings.h"
#include "numbers.h"
#include "paths.h"
#include "posed.h"

#include <firsthit/camera_file.h>
#include <firsthit/error.h>
#include <firsthit/framing.h>

#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>
#include <tuple>
#include <utility>

namespace firsthit::python {
namespace {

namespace py = pybind11;

using Pair = std::array<double, 2>;

SizedCamera make_camera(const py::object& eye, const py::object& direction, const py::object& up,
    const py::object& size, double fov_y, const std::optional<Pair>& focal,
    const std::optional<Pair>& principal_point, double skew,
    const std::optional<double>& orthographic_height)
{
    SizedCamera made;
    Camera& camera = made.view.camera;
    camera.eye = vector3(eye, "eye");
    camera.direction = vector3(direction, "direction");
    camera.up = vector3(up, "up");
    camera.fov_y_rad = fov_y;
    if (focal) camera.focal = glm::dvec2((*focal)[0], (*focal)[1]);
    if (principal_point)
        camera.principal_point = glm::dvec2((*principal_point)[0], (*principal_point)[1]);
    camera.skew = skew;
    camera.orthographic_height = orthographic_height;
    std::tie(made.view.width, made.view.height) = picture_size(size);
    return made;
}

std::vector<SizedCamera> cameras_of(
    const py::object& given_path, const std::optional<double>& pixel_center, const py::object& size)
{
    const std::string path = path_text(given_path);
    std::pair<int, int> given{0, 0};
    if (!size.is_none()) given = picture_size(size);
    std::vector<SizedCamera> all;
    for (const FileCamera& camera : read_cameras(path, pixel_center)) {
        SizedCamera made;
        if (size.is_none() && camera.width == 0)
            throw ArgumentError(
                path + ": the file does not say how large the pictures are: give size=");
        made.view.width = size.is_none() ? camera.width : given.first;
        made.view.height = size.is_none() ? camera.height : given.second;
        made.view.camera = resized_camera(camera, made.view.width, made.view.height);
        made.name = camera.name;
        all.push_back(std::move(made));
    }
    return all;
}

NamedView view_named(const std::string& name)
{
    static const std::map<std::string, NamedView> views{{"iso", NamedView::iso},
        {"front", NamedView::front}, {"back", NamedView::back}, {"left", NamedView::left},
        {"right", NamedView::right}, {"top", NamedView::top}, {"bottom", NamedView::bottom}};
    const auto found = views.find(name);
    if (found != views.end()) return found->second;
    throw py::value_error(
        "view: '" + name + "' is none: accepted are iso, front, back, left, right, top and bottom");
}

/// The camera that shows all of a world. up  or None: `usual_up`, unless the world rests on another side.
SizedCamera frame(PosedWorld& world, const std::string& view, const py::object& size,
    const py::object& up, const py::object& usual_up, bool all_around)
{
    SizedCamera made;
    std::tie(made.view.width, made.view.height) = picture_size(size);
    const std::shared_lock lock(world.use);
    glm::dvec3 axis = vector3(up.is_none() ? usual_up : up, "up");
    if (up.is_none() && axis.z > 0) axis = upward_axis(world.world, axis);
    Framing framing = named_view(view_named(view), axis);
    framing.aspect = double(made.view.width) / made.view.height;
    framing.all_around = all_around;
    made.view.camera = framing_camera(world.world, framing);
    return made;
}

py::object focal_of(const SizedCamera& self)
{
    const Camera& camera = self.view.camera;
    if (camera.orthographic_height) return py::none();
    if (camera.focal) return py::make_tuple(camera.focal->x, camera.focal->y);
    const double f = self.view.height / (2 * std::tan(camera.fov_y_rad / 2));
    return py::make_tuple(f, f);
}

py::object principal_point_of(const SizedCamera& self)
{
    const auto& point = self.view.camera.principal_point;
    if (point) return py::make_tuple(point->x, point->y);
    return py::make_tuple(self.view.width * 0.5, self.view.height * 0.5);
}

} // namespace

void add_cameras(py::module_& module)
{
    py::class_<SizedCamera>(
        module, "Camera", "A pinhole or orthographic camera and the size of its picture.")
        .def(py::init(&make_camera), py::kw_only(), py::arg("eye"), py::arg("direction"),
            py::arg("up"), py::arg("size"), py::arg("fov_y") = 0.78539816339744831,
            py::arg("focal") = py::none(), py::arg("principal_point") = py::none(),
            py::arg("skew") = 0.0, py::arg("orthographic_height") = py::none())
        .def_property_readonly(
            "eye", [](const SizedCamera& self) { return to_array(self.view.camera.eye); })
        .def_property_readonly("direction",
            [](const SizedCamera& self) { return to_array(self.view.camera.direction); })
        .def_property_readonly(
            "up", [](const SizedCamera& self) { return to_array(self.view.camera.up); })
        .def_property_readonly("width", [](const SizedCamera& self) { return self.view.width; })
        .def_property_readonly("height", [](const SizedCamera& self) { return self.view.height; })
        .def_property_readonly("focal", &focal_of)
        .def_property_readonly("principal_point", &principal_point_of)
        .def_property_readonly(
            "skew", [](const SizedCamera& self) { return self.view.camera.skew; })
        .def_property_readonly("orthographic_height",
            [](const SizedCamera& self) { return self.view.camera.orthographic_height; })
        .def_readonly("name", &SizedCamera::name)
        .def(
            "turned",
            [](const SizedCamera& self, const py::object& middle, const py::object& axis,
                double angle) {
                SizedCamera turned = self;
                turned.view.camera = turned_camera(
                    self.view.camera, vector3(middle, "middle"), vector3(axis, "axis"), angle);
                return turned;
            },
            py::arg("middle"), py::arg("axis"), py::arg("angle"));
    module.def("read_cameras", &cameras_of, py::arg("path"), py::kw_only(),
        py::arg("pixel_center") = py::none(), py::arg("size") = py::none());
    module.def("_frame", &frame);
    module.def("_scene_camera", [](PosedWorld& world, const py::object& size) -> py::object {
        if (world.source.scene->cameras.empty()) return py::none();
        SizedCamera made;
        made.view.camera = world.world.camera;
        std::tie(made.view.width, made.view.height) = picture_size(size);
        return py::cast(made);
    });
}

} // namespace firsthit::python
