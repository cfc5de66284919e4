// load_scene.cpp - from a name to a scene that is known to be sound.
#include "readers/aff/aff.h"
#include "samples/builtin.h"
#include "scene/model/check_scene.h"
#include "scene/model/default_light.h"
#include "io/text_cursor.h"
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

Scene read_file(const std::string& name, const LoadSettings& settings)
{
    const std::filesystem::path path(name);
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
        [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".aff" || extension == ".nff") return read_aff(path, settings);
    if (extension == ".ply" || extension == ".stl" || extension == ".obj")
        return read_mesh_file(path, settings);
    throw FileError(
        fmt::format("{}: unknown kind of file '{}'; accepted are .aff, .nff, .ply, .stl, "
                    ".obj, builtin:torus, builtin:robots, builtin:wave?n=N",
            name, printable(extension)));
}

} // namespace

Scene load_scene(const std::string& name, const LoadSettings& settings)
{
    const bool builtin = std::string_view(name).substr(0, kBuiltin.size()) == kBuiltin;
    Scene scene = builtin ? make_builtin(std::string_view(name).substr(kBuiltin.size()))
                          : read_file(name, settings);
    check_scene(scene);
    if (scene.lights.empty()) add_default_light(scene);
    return scene;
}

} // namespace firsthit
