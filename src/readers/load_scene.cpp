// load_scene.cpp - from a name to a scene that is known to be sound.
#include "readers/read_scene.h"

#include "readers/aff/aff.h"
#include "samples/builtin.h"
#include "scene/model/check_scene.h"
#include "scene/model/default_light.h"
#include "exact/cutouts.h"
#include "io/text_cursor.h"
#include "readers/assimp/read_assimp.h"
#include "readers/gltf/read_gltf.h"
#include "readers/mesh_file.h"

#include <firsthit/error.h>
#include <firsthit/scene.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <string_view>

namespace firsthit {
namespace {

constexpr std::string_view kBuiltin = "builtin:";

Scene read_file(
    const std::string& name, const LoadSettings& settings, std::vector<glm::uvec3>* corners)
{
    const std::filesystem::path path(name);
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
        [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".gltf" || extension == ".glb") return read_gltf(path, settings);
    if (extension == ".aff" || extension == ".nff") return read_aff(path, settings);
    if (is_assimp_extension(extension)) return read_assimp(path, settings);
    if (extension == ".ply" || extension == ".stl" || extension == ".obj" || extension == ".off")
        return read_mesh_file(path, settings, corners);
    throw FileError(fmt::format(
        "{}: unknown kind of file '{}'; accepted are .gltf, .glb, .fbx, .dae, .3mf, .aff, .nff, "
        ".ply, .stl, .obj, .off, builtin:torus, builtin:robots, builtin:room, builtin:wave?n=N",
        name, printable(extension)));
}

} // namespace

Scene read_scene(
    const std::string& name, const LoadSettings& settings, std::vector<glm::uvec3>* corners)
{
    const bool builtin = std::string_view(name).substr(0, kBuiltin.size()) == kBuiltin;
    Scene scene = builtin ? make_builtin(std::string_view(name).substr(kBuiltin.size()))
                          : read_file(name, settings, corners);
    check_scene(scene);
    if (settings.strict && !scene.warnings.empty())
        throw FileError(fmt::format("{}{}", scene.warnings.front(),
            scene.warnings.size() == 1
                ? ""
                : fmt::format(" (and {} other warnings)", scene.warnings.size() - 1)));
    if (has_blended_triangles(scene))
        scene.warnings.emplace_back(
            "surfaces of alpha mode blend shadow as if opaque where their opacity "
            "is at least 0.5, and not at all elsewhere");
    return scene;
}

Scene load_scene(const std::string& name, const LoadSettings& settings)
{
    Scene scene = read_scene(name, settings);
    if (scene.lights.empty()) add_default_light(scene);
    if (!scene.environment.map && has_physical_materials(scene))
        scene.environment.map = studio_environment();
    return scene;
}

} // namespace firsthit
