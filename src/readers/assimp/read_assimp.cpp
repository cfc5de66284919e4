// read_assimp.cpp - FBX, COLLADA and 3MF files as scenes, where the build has Assimp.
#include "readers/assimp/read_assimp.h"

#include "io/text_cursor.h"
#include "io/whole_file.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <optional>

#ifdef FIRSTHIT_WITH_ASSIMP
#include "readers/assimp/import_file.h"
#include "readers/assimp/imported_scene.h"
#include "readers/assimp/unit_of_3mf.h"
#endif

namespace firsthit {

namespace {

/// Bytes. Assimp holds a file several times over while it reads it.
constexpr std::uintmax_t kMostBytes = std::uintmax_t(1) << 30;

} // namespace

bool is_assimp_extension(std::string_view extension)
{
    constexpr std::array<std::string_view, 3> kRead{".fbx", ".dae", ".3mf"};
    return std::find(kRead.begin(), kRead.end(), extension) != kRead.end();
}

Scene read_assimp(const std::string& name, const std::string& bytes, const std::string& extension,
    const std::filesystem::path& folder, const LoadSettings& settings)
{
#ifdef FIRSTHIT_WITH_ASSIMP
    const ImportedFile file = import_file(name, bytes, extension, settings.crease_angle_rad);
    if (extension != ".3mf") return ImportedScene(*file.scene, name, extension, folder, 1).make();
    const std::string unit = unit_of_3mf(bytes);
    const std::optional<double> unit_m = metres_of_3mf_unit(unit);
    constexpr double kMillimetre = 1e-3; // the format's own choice
    Scene scene =
        ImportedScene(*file.scene, name, extension, folder, unit_m.value_or(kMillimetre)).make();
    if (!unit.empty() && !unit_m)
        scene.warnings.push_back(fmt::format(
            "{}: the unit '{}' is none of 3MF's; millimetres are taken", name, printable(unit)));
    return scene;
#else
    (void)bytes;
    (void)folder;
    (void)settings;
    throw FileError(
        fmt::format("{}: {} files need the library Assimp, which was not there when "
                    "firsthit was built: apt-get install libassimp-dev, and build again",
            name, extension));
#endif
}

Scene read_assimp(const std::filesystem::path& path, const LoadSettings& settings)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
        [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    Scene scene =
        read_assimp(path.string(), read_whole_file(path, kMostBytes), extension, folder, settings);
    scene.files.insert(scene.files.begin(), path.string());
    return scene;
}

} // namespace firsthit
