// frames.cpp - pictures: settings, frames, and renderers that make one or many at a time.
#include "arrays.h"
#include "bindings.h"
#include "camera.h"
#include "interpreter.h"
#include "paths.h"
#include "renderer.h"

#include <firsthit/picture.h>

#include <pybind11/stl.h>

#include <map>
#include <string>
#include <utility>

namespace firsthit::python {
namespace {

namespace py = pybind11;

template <class T>
T named(const std::map<std::string, T>& all, const std::string& name, const char* what)
{
    const auto found = all.find(name);
    if (found != all.end()) return found->second;
    std::string accepted;
    for (const auto& [known, value] : all) accepted += (accepted.empty() ? "" : ", ") + known;
    throw py::value_error(std::string(what) + ": '" + name + "' is none: accepted are " + accepted);
}

const std::map<std::string, Engine>& engines()
{
    static const std::map<std::string, Engine> all{{"cpu", Engine::cpu}, {"hybrid", Engine::hybrid},
        {"gpu", Engine::gpu}, {"auto", Engine::automatic}};
    return all;
}

const std::map<std::string, Shadows>& shadow_kinds()
{
    static const std::map<std::string, Shadows> all{{"auto", Shadows::automatic},
        {"none", Shadows::none}, {"map", Shadows::map}, {"exact", Shadows::exact}};
    return all;
}

/// The channels of a picture: "color", "alpha", and the names of planes.
void set_channels(Settings& settings, const std::vector<std::string>& channels)
{
    settings.color = false;
    settings.alpha = false;
    settings.aovs.clear();
    for (const std::string& name : channels)
        if (name == "color")
            settings.color = true;
        else if (name == "alpha")
            settings.alpha = settings.color = true;
        else
            settings.aovs.push_back(aov_from_name(name));
}

Settings make_settings(const std::vector<std::string>& channels, const py::object& samples,
    const py::object& aa, const std::string& engine, const std::string& shadows,
    const py::object& interleave, const py::object& sky)
{
    Settings settings;
    set_channels(settings, channels);
    settings.samples = whole_number(samples, "samples", 1, 16);
    settings.adaptive = whole_number(aa, "aa", 1, 16);
    settings.engine = named(engines(), engine, "engine");
    settings.shadows = named(shadow_kinds(), shadows, "shadows");
    settings.interleave = whole_number(interleave, "interleave", 1, 16);
    if (!sky.is_none()) settings.sky = sky.cast<Sky>();
    return settings;
}

py::object plane(
    const py::object& owner, const std::vector<float>& value, int height, int width, int channels)
{
    if (value.empty()) return py::none();
    std::vector<py::ssize_t> shape{height, width};
    if (channels > 1) shape.push_back(channels);
    return view_of(value.data(), std::move(shape), owner);
}

/// A channel as an array over the frame's own memory.
py::object channel(const py::object& self, const std::string& name)
{
    const Film& film = self.cast<const Frame&>().film;
    py::object array = py::none();
    if (name == "color")
        array = plane(self, film.color.value, film.height, film.width, 3);
    else if (name == "alpha")
        array = plane(self, film.alpha.value, film.height, film.width, 1);
    else {
        const Aov aov = aov_from_name(name);
        if (holds_ids(aov)) {
            if (!film.ids(aov).empty())
                array = view_of(film.ids(aov).data(), {film.height, film.width}, self);
        } else if (aov == Aov::lit && !film[aov].empty()) {
            array = view_of(
                film[aov].value.data(), {film.height, film.width, film[aov].channels}, self);
        } else {
            array = plane(self, film[aov].value, film.height, film.width, film[aov].channels);
        }
    }
    if (array.is_none())
        throw py::key_error("'" + name + "' was not asked for: channels=[..., \"" + name + "\"]");
    return array;
}

std::vector<std::string> channels_of(const Frame& frame)
{
    std::vector<std::string> names;
    if (!frame.film.color.empty()) names.emplace_back("color");
    if (!frame.film.alpha.empty()) names.emplace_back("alpha");
    for (int k = 0; k < kAovCount; ++k) {
        const Aov aov = Aov(k);
        if (holds_ids(aov) ? !frame.film.ids(aov).empty() : !frame.film[aov].empty())
            names.emplace_back(aov_name(aov));
    }
    return names;
}

py::dict stats_of(const Frame& frame)
{
    const Stats& s = frame.stats;
    py::dict all;
    const std::pair<const char*, double> times[] = {{"pose_ms", s.pose_ms},
        {"setup_ms", s.setup_ms}, {"raster_ms", s.raster_ms}, {"resolve_ms", s.resolve_ms},
        {"shadow_ms", s.shadow_ms}, {"sky_ms", s.sky_ms}, {"shade_ms", s.shade_ms},
        {"total_ms", s.total_ms}};
    for (const auto& [name, ms] : times) all[name] = ms;
    all["triangles"] = s.triangles;
    all["hits"] = s.hits;
    return all;
}

} // namespace

void add_frames(py::module_& module)
{
    py::class_<Settings>(module, "_Settings")
        .def(py::init(&make_settings), py::arg("channels"), py::arg("samples"), py::arg("aa"),
            py::arg("engine"), py::arg("shadows"), py::arg("interleave"), py::arg("sky"));
    py::class_<Frame>(module, "Frame", "A picture: its channels are arrays over its own memory.")
        .def(py::init<>())
        .def_property_readonly("width", [](const Frame& self) { return self.film.width; })
        .def_property_readonly("height", [](const Frame& self) { return self.film.height; })
        .def_property_readonly("channels", &channels_of)
        .def_property_readonly("stats", &stats_of)
        .def_property_readonly("engine", [](const Frame& self) { return self.engine; })
        .def(
            "save",
            [](const Frame& self, const py::object& given_path, bool dither,
                const py::object& quality) {
                const std::string path = path_text(given_path);
                PictureOptions options;
                options.dither = dither;
                options.quality = whole_number(quality, "quality", 1, 100);
                const Unlocked unlocked;
                write_picture(self.film, path, options);
            },
            py::arg("path"), py::kw_only(), py::arg("dither") = true, py::arg("quality") = 95)
        .def("__getitem__", &channel, py::arg("channel"))
        .def("__contains__", [](const Frame& self, const std::string& name) {
            for (const std::string& known : channels_of(self))
                if (known == name) return true;
            return false;
        });
    py::class_<PythonRenderer>(
        module, "Renderer", "Makes frames, and keeps memory and threads between them.")
        .def(py::init<const py::object&>(), py::arg("threads") = 0)
        .def_property_readonly("threads", &PythonRenderer::threads)
        .def("_render", &PythonRenderer::render);
    module.def("_render_batch", &render_batch);
}

} // namespace firsthit::python
