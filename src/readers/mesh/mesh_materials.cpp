// mesh_materials.cpp - the materials of a mesh file, from its libraries.
#include "readers/mesh/mesh_materials.h"

#include "readers/find_beside.h"
#include "readers/mesh/mtl/mtl.h"
#include "io/text_cursor.h"
#include "io/whole_file.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <system_error>
#include <unordered_map>
#include <unordered_set>

namespace firsthit {
namespace {

constexpr std::size_t kMaxLibrary = std::size_t(1) << 26; // 64 MB: no library is that long

/// Missing libraries that are named.
constexpr std::size_t kMostMissing = 16;

struct FoundMaterial {
    MtlMaterial mtl;
    std::filesystem::path folder; // of its library
};
using Library = std::unordered_map<std::string, FoundMaterial>;

bool is_file(const std::filesystem::path& path)
{
    std::error_code error;
    return std::filesystem::is_regular_file(path, error);
}

/// "mtllib a.mtl b.mtl" names two libraries, "mtllib my file.mtl" one: what exists decides.
std::vector<std::string> library_names(const std::string& line, const std::filesystem::path& folder)
{
    if (is_file(find_beside(folder, line))) return {line};
    std::istringstream words(line);
    std::vector<std::string> names;
    for (std::string word; words >> word;) names.push_back(word);
    return names;
}

/// A library that cannot be read costs no mesh.
void read_library(const std::filesystem::path& path, Library& library, SceneBuilder& scene)
{
    Problems problems;
    try {
        for (MtlMaterial& mtl :
            read_mtl(read_whole_file(path, kMaxLibrary), path.string(), problems)) {
            const std::string key = mtl.name;
            library.try_emplace(key, FoundMaterial{std::move(mtl), path.parent_path()});
        }
    } catch (const Error& error) {
        scene.warn(fmt::format("{}; its materials are left out", error.what()));
    }
    for (std::string& warning : problems.lines(path.string())) scene.warn(std::move(warning));
}

/// The first definition of a name counts.
Library read_libraries(const RawMesh& raw, const std::string& name,
    const std::filesystem::path& folder, SceneBuilder& scene)
{
    Library library;
    std::unordered_set<std::string> seen;
    std::size_t missing = 0;
    for (std::string line : raw.material_files) {
        std::replace(line.begin(), line.end(), '\\', '/');
        if (line.size() > 2 && line.front() == '"' && line.back() == '"')
            line = line.substr(1, line.size() - 2);
        for (const std::string& file : library_names(line, folder)) {
            if (!seen.insert(file).second) continue;
            const std::filesystem::path path = find_beside(folder, file);
            if (!is_file(path)) {
                if (missing++ < kMostMissing)
                    scene.warn(
                        fmt::format("{}: material library '{}' is missing", name, printable(file)));
                continue;
            }
            scene.add_file(path.string());
            read_library(path, library, scene);
        }
    }
    if (missing > kMostMissing)
        scene.warn(fmt::format(
            "{}: {} other material libraries are missing", name, missing - kMostMissing));
    return library;
}

} // namespace

std::vector<MtlMeshNeeds> read_materials(const RawMesh& raw, const std::string& name,
    const std::filesystem::path& folder, bool has_uv, SceneBuilder& scene)
{
    Library library;
    if (!folder.empty()) library = read_libraries(raw, name, folder, scene);

    MtlSettings settings{.physical = false,
        .has_uv = has_uv,
        .has_colors = !raw.color.empty() || !raw.triangle_color.empty()};
    for (const std::string& wanted : raw.materials)
        if (const auto found = library.find(wanted); found != library.end())
            settings.physical |= found->second.mtl.is_physical();

    MtlTextures textures(scene);
    std::vector<MtlMeshNeeds> needs;
    std::string missing;
    std::size_t missing_count = 0;
    std::size_t clear_count = 0;
    for (const std::string& wanted : raw.materials) {
        MtlMeshNeeds& needed = needs.emplace_back();
        const auto found = library.find(wanted);
        if (found == library.end()) {
            if (!wanted.empty() && missing_count++ == 0) missing = wanted;
            Material plain = make_default_material(settings);
            plain.name = wanted;
            scene.add_material(std::move(plain));
            continue;
        }
        const auto& [mtl, library_folder] = found->second;
        clear_count += mtl.opacity == 0;
        textures.set_folder(library_folder);
        scene.add_material(make_material(mtl, settings, textures, needed));
    }
    if (missing_count == 1)
        scene.warn(fmt::format("{}: the material '{}' is in no library: {}", name,
            printable(missing), settings.has_colors ? "white" : "grey"));
    if (missing_count > 1)
        scene.warn(fmt::format("{}: {} materials are in no library ('{}' is one): {}", name,
            missing_count, printable(missing), settings.has_colors ? "white" : "grey"));
    if (clear_count > 0)
        scene.warn(
            fmt::format("{}: materials with d 0 are invisible ({} of them)", name, clear_count));
    scene.add_material(make_default_material(settings));
    needs.emplace_back();
    return needs;
}

} // namespace firsthit
