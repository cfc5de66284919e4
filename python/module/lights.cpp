// lights.cpp - lights, the sky, and where the sun is.
#include "arrays.h"
#include "bindings.h"
#include "numbers.h"

#include <firsthit/light.h>
#include <firsthit/sky.h>
#include <firsthit/studio.h>
#include <firsthit/sun.h>

#include <pybind11/stl.h>

#include <cmath>
#include <string>

namespace firsthit::python {
namespace {

namespace py = pybind11;

Light make_light(const std::string& kind, const py::object& position, const py::object& direction,
    const Color& color, double inner_rad, double outer_rad, bool inverse_square, double range,
    bool on_camera, const std::string& name)
{
    Light light;
    if (kind == "point")
        light.kind = Light::Kind::point;
    else if (kind == "spot")
        light.kind = Light::Kind::spot;
    else if (kind == "directional")
        light.kind = Light::Kind::directional;
    else
        throw py::value_error(
            "kind: '" + kind + "' is none: accepted are point, spot and directional");
    if (!position.is_none()) light.position = vector3(position, "position");
    if (!direction.is_none()) light.direction = vector3(direction, "direction");
    light.color = to_vec3(color);
    light.inner_rad = inner_rad;
    light.outer_rad = outer_rad;
    light.inverse_square = inverse_square;
    light.range = range;
    light.on_camera = on_camera;
    light.name = name;
    return light;
}

int direction_count(const py::object& object)
{
    return whole_number(object, "sky: directions", 0, Sky::kMostDirections);
}

Sky make_sky(const py::object& directions, const Color& color, const Color& ground, float bounce,
    const py::object& up)
{
    Sky sky;
    sky.directions = direction_count(directions);
    sky.color = to_vec3(color);
    sky.ground = to_vec3(ground);
    sky.bounce = bounce;
    if (!up.is_none()) sky.up = vector3(up, "up");
    return sky;
}

} // namespace

void add_lights(py::module_& module)
{
    py::class_<Light>(module, "Light", "A point, a spot or a directional light.")
        .def(py::init(&make_light), py::arg("kind"), py::kw_only(),
            py::arg("position") = py::none(), py::arg("direction") = py::none(),
            py::arg("color") = Color{1, 1, 1}, py::arg("inner") = 0.0,
            py::arg("outer") = 0.78539816339744831, py::arg("inverse_square") = false,
            py::arg("range") = 0.0, py::arg("on_camera") = false, py::arg("name") = "")
        .def_property_readonly(
            "position", [](const Light& self) { return to_array(self.position); })
        .def_property_readonly(
            "direction", [](const Light& self) { return to_array(self.direction); })
        .def_property_readonly("color",
            [](const Light& self) {
                return Color{self.color.x, self.color.y, self.color.z};
            })
        .def_property_readonly("kind",
            [](const Light& self) {
                return self.kind == Light::Kind::point  ? "point"
                       : self.kind == Light::Kind::spot ? "spot"
                                                        : "directional";
            })
        .def_readonly("on_camera", &Light::on_camera)
        .def_readonly("name", &Light::name);
    py::class_<Sky>(module, "Sky", "Light from all of the sky, which hollows keep out.")
        .def(py::init(&make_sky), py::arg("directions"), py::kw_only(),
            py::arg("color") = Color{0.3f, 0.3f, 0.3f},
            py::arg("ground") = Color{0.09f, 0.09f, 0.09f}, py::arg("bounce") = 0.0f,
            py::arg("up") = py::none())
        .def_property(
            "directions", [](const Sky& self) { return self.directions; },
            [](Sky& self, const py::object& value) { self.directions = direction_count(value); });
    module.def("studio_sky", &studio_sky);
    module.def(
        "sun_position",
        [](double latitude, double longitude, const py::object& time) {
            const double seconds = py::isinstance<py::str>(time)
                                       ? unix_time(time.cast<std::string>())
                                       : time.cast<double>();
            const SunPosition sun = sun_position(latitude, longitude, seconds);
            const double degree = std::acos(-1.0) / 180;
            return py::make_tuple(
                sun.azimuth_rad / degree, sun.elevation_rad / degree, to_array(to_sun(sun)));
        },
        py::arg("latitude"), py::arg("longitude"), py::arg("time"));
}

} // namespace firsthit::python
