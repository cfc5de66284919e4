// mesh_file.cpp - PLY, STL, OBJ and OFF files as scenes.
#include "scene/model/default_material.h"
#include "readers/find_beside.h"
#include "readers/mesh_file.h"

#include "readers/mesh/raw_mesh.h"
#include "readers/mesh/mesh_materials.h"
#include "readers/mesh/mesh_vertices.h"
#include "readers/image/image_file.h"
#include "io/text_cursor.h"
#include "io/whole_file.h"

#include <firsthit/error.h>
#include <firsthit/scene_builder.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <system_error>
#include <utility>
#include <variant>

namespace firsthit {
namespace {

RawMesh read(std::string bytes, const std::string& extension, const std::string& name, Tasks& tasks)
{
    RawMesh raw;
    if (extension == ".ply")
        raw = read_ply(bytes, name, tasks);
    else if (extension == ".stl")
        raw = read_stl(bytes, name);
    else if (extension == ".obj")
        raw = read_obj(bytes, name);
    else if (extension == ".off")
        raw = read_off(bytes, name);
    else
        throw ArgumentError(
            fmt::format("'{}' is no mesh file; accepted are .ply, .stl, .obj, .off", extension));
    leave_out_not_finite(raw, name);
    return raw;
}

/// Characters of a material's name that are the name of its instances, of which there may be many.
constexpr std::size_t kMostName = 256;
/// Starting threads takes longer than reading a small file. 0: as many as there are cores.
int threads_for(const std::string& bytes)
{
    return bytes.size() < (std::size_t(1) << 18) ? 1 : 0;
}

/// Reads the texture of what has no material: beside the file, by its whole path or its bare name.
/// returns  its number; -1 where there is none, with a warning where there should be
std::int32_t read_default_texture(const RawMesh& raw, const std::string& name,
    const std::filesystem::path& folder, SceneBuilder& scene)
{
    if (raw.texture.empty() || folder.empty()) return -1;
    if (raw.uv.empty()) {
        scene.warn(fmt::format("{}: the texture '{}' is not used: there are no texture coordinates",
            name, printable(raw.texture)));
        return -1;
    }
    const std::filesystem::path path = find_beside(folder, raw.texture);
    std::error_code error;
    if (std::filesystem::is_regular_file(path, error)) scene.add_file(path.string());
    try {
        return static_cast<std::int32_t>(scene.add_texture(read_texture(path)));
    } catch (const Error& failed) {
        scene.warn(fmt::format("{}; a plain colour is used", failed.what()));
        return -1;
    }
}

/// What has no material is white where a texture of its own shows.
Material white_material(std::int32_t texture)
{
    Material white = default_material();
    white.name = "white";
    Phong& phong = std::get<Phong>(white.model);
    phong.ambient = phong.diffuse = glm::vec3(1);
    phong.texture = texture;
    return white;
}

/// Every triangle is in exactly one run: one with the default material is put in front if needed.
std::vector<MeshRun> complete_runs(const RawMesh& raw, std::uint32_t default_material)
{
    std::vector<MeshRun> runs = raw.runs;
    if (runs.empty() || runs.front().first_triangle > 0)
        runs.insert(runs.begin(), MeshRun{.first_triangle = 0, .material = default_material});
    if (runs.back().first_triangle == raw.index.size()) runs.pop_back();
    return runs;
}

/// How normals are made.
struct Smoothing {
    double crease_angle_rad;
    Tasks& tasks;
};

/// name    of the file, for messages
/// folder  as read_mesh
Scene scene_of(RawMesh raw, const std::string& name, const std::filesystem::path& folder,
    const Smoothing& smoothing)
{
    SceneBuilder scene(std::filesystem::path(name).filename().string());
    const std::uint32_t node =
        scene.add_node({.name = std::filesystem::path(name).filename().string()});
    scene.set_ambient(glm::vec3(kMeshAmbient));
    for (std::string& warning : raw.problems.lines(name)) scene.warn(std::move(warning));
    const std::vector<MtlMeshNeeds> needs =
        read_materials(raw, name, folder, !raw.uv.empty(), scene);
    const std::int32_t texture = read_default_texture(raw, name, folder, scene);

    // The default material is the last one.
    const auto default_number = static_cast<std::uint32_t>(raw.materials.size());
    std::vector<std::string> names;
    for (const std::string& material : raw.materials)
        names.push_back(material.substr(0, kMostName));
    names.push_back(texture >= 0 ? white_material(texture).name : default_material().name);
    const std::vector<MeshRun> runs = complete_runs(raw, default_number);
    std::vector<std::size_t> first_triangle;
    for (const MeshRun& run : runs) first_triangle.push_back(run.first_triangle);
    std::vector<Mesh> meshes =
        make_meshes(std::move(raw), first_triangle, smoothing.crease_angle_rad, smoothing.tasks);
    for (std::size_t r = 0; r < meshes.size(); ++r) {
        needs[runs[r].material].apply(meshes[r]);
        scene.add_instance(scene.add_mesh(std::move(meshes[r])), node, runs[r].material, -1,
            runs[r].name.empty() ? names[runs[r].material] : runs[r].name);
    }
    Scene built = scene.build();
    if (texture >= 0) built.materials[default_number] = white_material(texture);
    return built;
}

} // namespace

Scene read_mesh_file(const std::filesystem::path& path, const LoadSettings& settings,
    std::vector<glm::uvec3>* corners)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
        [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    std::string bytes = read_whole_file(path, kMaxMeshFile);
    Tasks tasks(threads_for(bytes));
    RawMesh raw = read(std::move(bytes), extension, path.string(), tasks);
    if (corners) *corners = raw.index;
    Scene scene =
        scene_of(std::move(raw), path.string(), folder, {settings.crease_angle_rad, tasks});
    scene.files.insert(scene.files.begin(), path.string());
    return scene;
}

Scene read_mesh(std::string bytes, const std::string& extension, const std::string& name,
    const std::filesystem::path& folder, const LoadSettings& settings)
{
    Tasks tasks(threads_for(bytes));
    return scene_of(read(std::move(bytes), extension, name, tasks), name, folder,
        {settings.crease_angle_rad, tasks});
}

} // namespace firsthit
