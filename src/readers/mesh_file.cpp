// mesh_file.cpp - PLY, STL and OBJ files as scenes.
#include "scene/model/default_material.h"
#include "readers/mesh_file.h"

#include "readers/mesh/raw_mesh.h"
#include "readers/mesh/mesh_materials.h"
#include "readers/mesh/mesh_vertices.h"
#include "readers/mesh/mtl.h"
#include "io/whole_file.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace firsthit {
namespace {

RawMesh read(std::string bytes, const std::string& extension, const std::string& name)
{
    if (extension == ".ply") return read_ply(bytes, name);
    if (extension == ".stl") return read_stl(bytes, name);
    if (extension == ".obj") return read_obj(bytes, name);
    throw ArgumentError(
        fmt::format("'{}' is no mesh file; accepted are .ply, .stl, .obj", extension));
}

/// Every triangle is in exactly one run: one with the default material is put in front if needed.
std::vector<MaterialRun> complete_runs(const RawMesh& raw, std::uint32_t default_material)
{
    std::vector<MaterialRun> runs = raw.material_runs;
    if (runs.empty() || runs.front().first_triangle > 0)
        runs.insert(runs.begin(), MaterialRun{.first_triangle = 0, .material = default_material});
    if (runs.back().first_triangle == raw.index.size()) runs.pop_back();
    return runs;
}

} // namespace

Scene read_mesh_file(const std::filesystem::path& path, const LoadSettings& settings)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
        [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    Scene scene =
        read_mesh(read_whole_file(path, kMaxMeshFile), extension, path.string(), folder, settings);
    scene.files.insert(scene.files.begin(), path.string());
    return scene;
}

Scene read_mesh(std::string bytes, const std::string& extension, const std::string& name,
    const std::filesystem::path& folder, const LoadSettings& settings)
{
    RawMesh raw = read(std::move(bytes), extension, name);

    Scene scene;
    scene.name = std::filesystem::path(name).filename().string();
    scene.nodes.push_back({.name = scene.name});
    scene.ambient = glm::vec3(kMeshAmbient);
    scene.warnings = std::move(raw.warnings);
    read_materials(raw, name, folder, !raw.uv.empty(), scene);

    // The default material is the last one.
    const auto last_material = static_cast<std::uint32_t>(scene.materials.size() - 1);
    const std::vector<MaterialRun> runs = complete_runs(raw, last_material);
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const std::size_t end = r + 1 < runs.size() ? runs[r + 1].first_triangle : raw.index.size();
        Part& part = scene.parts.emplace_back();
        part.material = runs[r].material;
        part.name = scene.materials[part.material].name;
        part.first_triangle = static_cast<std::uint32_t>(runs[r].first_triangle);
        part.triangle_count = static_cast<std::uint32_t>(end - runs[r].first_triangle);
        scene.owner.insert(scene.owner.end(), part.triangle_count, static_cast<std::uint32_t>(r));
    }
    make_vertices(std::move(raw), settings.crease_angle_rad, scene);
    return scene;
}

} // namespace firsthit
