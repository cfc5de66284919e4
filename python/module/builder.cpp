// builder.cpp - scenes from arrays: materials, meshes, instances.
#include "arrays.h"
#include "bindings.h"
#include "posed.h"

#include <firsthit/scene_builder.h>
#include <firsthit/studio.h>

#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <variant>

namespace firsthit::python {
namespace {

namespace py = pybind11;

/// A material and the picture on it.
struct PaintedMaterial {
    Material material;
    std::optional<Picture> picture;
};

/// (H, W, 3) or (H, W, 4) bytes, sRGB, top row first.
Picture picture_of(const py::handle& object)
{
    const py::module_ numpy = py::module_::import("numpy");
    const py::array given = numpy.attr("asarray")(object);
    if (given.ndim() != 3 || (given.shape(2) != 3 && given.shape(2) != 4) ||
        given.dtype().kind() != 'u' || given.itemsize() != 1)
        throw py::value_error("texture: got " + std::string(py::str(given.dtype())) + " " +
                              std::string(py::str(given.attr("shape"))) +
                              ", wanted uint8 (H, W, 3) or (H, W, 4)");
    const auto bytes =
        py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>::ensure(given);
    Picture picture;
    if (given.shape(0) > Texture::kMaxSide || given.shape(1) > Texture::kMaxSide)
        throw py::value_error("texture: a side has more than 16384 pixels");
    picture.height = int(given.shape(0));
    picture.width = int(given.shape(1));
    const auto channels = std::size_t(given.shape(2));
    picture.pixel.resize(std::size_t(picture.width) * std::size_t(picture.height));
    const std::uint8_t* byte = bytes.data();
    for (std::uint32_t& pixel : picture.pixel) {
        pixel = 0xFF000000u;
        if (channels == 4) pixel = std::uint32_t(byte[3]) << 24;
        pixel |=
            std::uint32_t(byte[0]) | std::uint32_t(byte[1]) << 8 | std::uint32_t(byte[2]) << 16;
        byte += channels;
    }
    return picture;
}

/// throws  ValueError: it is no number from 0 to 1
void check_share(float share, const char* name)
{
    if (!(0 <= share && share <= 1))
        throw py::value_error(std::string(name) + ": " + std::to_string(share) +
                              " is out of range: accepted is 0 to 1");
}

AlphaMode alpha_mode(const std::string& name)
{
    if (name == "opaque") return AlphaMode::opaque;
    if (name == "mask") return AlphaMode::mask;
    if (name == "blend") return AlphaMode::blend;
    throw py::value_error("alpha: '" + name + "' is no mode: accepted are opaque, mask and blend");
}

PaintedMaterial make_material(const std::string& name, const Color& color, const std::string& model,
    const std::optional<Color>& specular, float shininess, const std::optional<Color>& ambient,
    float metallic, float roughness, const Color& emission, float opacity, const std::string& alpha,
    float cutoff, const py::object& texture)
{
    check_share(opacity, "opacity");
    check_share(cutoff, "cutoff");
    check_share(metallic, "metallic");
    check_share(roughness, "roughness");
    PaintedMaterial painted;
    Material& material = painted.material;
    material.name = name;
    if (model == "phong")
        material.model = Phong{.ambient = ambient ? to_vec3(*ambient) : 0.1f * to_vec3(color),
            .diffuse = to_vec3(color),
            .specular = specular ? to_vec3(*specular) : glm::vec3(0),
            .shininess = shininess};
    else if (model == "unlit")
        material.model = Unlit{.color = to_vec3(color)};
    else if (model == "metallic_roughness")
        material.model = MetallicRoughness{.base_color = to_vec3(color),
            .metallic = metallic,
            .roughness = roughness,
            .emission = to_vec3(emission)};
    else
        throw py::value_error(
            "model: '" + model + "' is none: accepted are phong, unlit and metallic_roughness");
    material.opacity = opacity;
    material.alpha = alpha_mode(alpha);
    material.alpha_cutoff = cutoff;
    if (!texture.is_none()) painted.picture = picture_of(texture);
    return painted;
}

/// Gives the texture with this number to whatever the model paints with.
struct Paint {
    std::int32_t texture;
    void operator()(Phong& model) const { model.texture = texture; }
    void operator()(Unlit& model) const { model.texture.texture = texture; }
    void operator()(MetallicRoughness& model) const { model.base_color_texture.texture = texture; }
};

/// Puts scenes together; scene() can be called once.
class Builder {
  public:
    explicit Builder(const std::string& name) : builder_(name) {}

    std::uint32_t add_material(PaintedMaterial painted)
    {
        if (painted.picture) {
            const auto number = std::int32_t(
                builder_.add_texture(Texture(painted.material.name, *painted.picture)));
            std::visit(Paint{number}, painted.material.model);
            if (painted.material.alpha != AlphaMode::opaque)
                painted.material.opacity_texture.texture = number;
        }
        return builder_.add_material(std::move(painted.material));
    }

    std::uint32_t add_mesh(const py::object& vertices, const py::object& index,
        const py::object& normals, const py::object& uv, const py::object& colors,
        const std::string& name)
    {
        Mesh mesh;
        mesh.shape.name = name;
        mesh.position = vectors3(vertices, "vertices");
        mesh.index = triangles(index, "triangles");
        mesh.normal = vectors3(normals, "normals");
        mesh.uv = vectors2(uv, "uv");
        mesh.color = colors4(colors, "colors");
        const auto fits = [&](std::size_t count, const char* what) {
            if (count > 0 && count != mesh.position.size())
                throw py::value_error(std::string(what) + ": got " + std::to_string(count) +
                                      " for " + std::to_string(mesh.position.size()) + " vertices");
        };
        fits(mesh.normal.size(), "normals");
        fits(mesh.uv.size(), "uv");
        fits(mesh.color.size(), "colors");
        return builder_.add_mesh(std::move(mesh));
    }

    void add_instance(std::uint32_t mesh, const py::object& world_from_mesh, std::uint32_t material,
        const std::string& name)
    {
        Node node;
        node.name = name;
        if (!world_from_mesh.is_none()) node.local = matrix4(world_from_mesh, "world_from_mesh");
        builder_.add_instance(mesh, builder_.add_node(std::move(node)), material, -1, name);
    }

    void add_light(const Light& light) { builder_.add_light(light); }

    void set_background(const Color& color) { builder_.set_background(to_vec3(color)); }

    void set_ambient(const Color& color) { builder_.set_ambient(to_vec3(color)); }

    LoadedScene scene(const std::optional<bool>& studio)
    {
        if (built_) throw py::value_error("the builder has given its scene away: make another");
        built_ = true;
        LoadedScene loaded;
        Scene scene = builder_.build();
        loaded.studio = studio.value_or(!has_own_lights(scene));
        if (loaded.studio) set_up_studio(scene);
        loaded.scene = std::make_shared<const Scene>(std::move(scene));
        return loaded;
    }

  private:
    SceneBuilder builder_;
    bool built_ = false;
};

/// A scene of one mesh.
LoadedScene one_mesh(const py::object& vertices, const py::object& index, const py::object& normals,
    const py::object& uv, const py::object& colors, const std::optional<PaintedMaterial>& material,
    const std::string& name, const std::optional<bool>& studio)
{
    Builder builder(name);
    const std::uint32_t mesh = builder.add_mesh(vertices, index, normals, uv, colors, name);
    PaintedMaterial painted = material.value_or(PaintedMaterial());
    if (!material) painted.material.name = "default";
    builder.add_instance(mesh, py::none(), builder.add_material(std::move(painted)), name);
    return builder.scene(studio);
}

} // namespace

void add_builder(py::module_& module)
{
    py::class_<PaintedMaterial>(module, "Material", "How a surface reflects light.")
        .def(py::init(&make_material), py::kw_only(), py::arg("name") = "",
            py::arg("color") = Color{0.8f, 0.8f, 0.8f}, py::arg("model") = "phong",
            py::arg("specular") = py::none(), py::arg("shininess") = 1.0f,
            py::arg("ambient") = py::none(), py::arg("metallic") = 0.0f,
            py::arg("roughness") = 0.5f, py::arg("emission") = Color{0, 0, 0},
            py::arg("opacity") = 1.0f, py::arg("alpha") = "opaque", py::arg("cutoff") = 0.5f,
            py::arg("texture") = py::none())
        .def_property_readonly(
            "name", [](const PaintedMaterial& self) { return self.material.name; });
    py::reinterpret_borrow<py::class_<LoadedScene>>(module.attr("Scene"))
        .def(py::init(&one_mesh), py::arg("vertices"), py::arg("triangles"), py::kw_only(),
            py::arg("normals") = py::none(), py::arg("uv") = py::none(),
            py::arg("colors") = py::none(), py::arg("material") = py::none(),
            py::arg("name") = "scene", py::arg("studio") = py::none());
    py::class_<Builder>(module, "SceneBuilder", "Puts a scene together from arrays.")
        .def(py::init<const std::string&>(), py::arg("name") = "scene")
        .def("add_material", &Builder::add_material, py::arg("material"))
        .def("add_mesh", &Builder::add_mesh, py::arg("vertices"), py::arg("triangles"),
            py::kw_only(), py::arg("normals") = py::none(), py::arg("uv") = py::none(),
            py::arg("colors") = py::none(), py::arg("name") = "")
        .def("add_instance", &Builder::add_instance, py::arg("mesh"), py::kw_only(),
            py::arg("world_from_mesh") = py::none(), py::arg("material"), py::arg("name") = "")
        .def("add_light", &Builder::add_light, py::arg("light"))
        .def("set_background", &Builder::set_background, py::arg("color"))
        .def("set_ambient", &Builder::set_ambient, py::arg("color"))
        .def("build", &Builder::scene, py::kw_only(), py::arg("studio") = py::none());
}

} // namespace firsthit::python
