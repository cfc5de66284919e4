// mesh_materials.cpp - the materials of a mesh file, from its libraries.
#include "scene/model/default_material.h"
#include "readers/mesh/mesh_materials.h"

#include "readers/image/image_file.h"
#include "readers/mesh/mtl.h"
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
    if (is_file(folder / line)) return {line};
    std::istringstream words(line);
    std::vector<std::string> names;
    for (std::string word; words >> word;) names.push_back(word);
    return names;
}

/// The first definition of a name counts.
Library read_libraries(
    const RawMesh& raw, const std::string& name, const std::filesystem::path& folder, Scene& scene)
{
    Library library;
    std::unordered_set<std::string> seen;
    for (std::string line : raw.material_files) {
        std::replace(line.begin(), line.end(), '\\', '/');
        for (const std::string& file : library_names(line, folder)) {
            if (!seen.insert(file).second) continue;
            const std::filesystem::path path = folder / file;
            if (!is_file(path)) {
                scene.warnings.push_back(
                    fmt::format("{}: material library '{}' is missing", name, printable(file)));
                continue;
            }
            add_file(path, scene.files);
            for (MtlMaterial& mtl : read_mtl(read_whole_file(path, kMaxLibrary), path.string())) {
                const std::string key = mtl.name;
                library.try_emplace(key, FoundMaterial{std::move(mtl), path.parent_path()});
            }
        }
    }
    return library;
}

/// Reads each texture once.
class Textures {
  public:
    explicit Textures(Scene& scene) : scene_(scene) {}

    /// returns  its number, -1 where it cannot be read
    std::int32_t number(const std::filesystem::path& path)
    {
        const auto [found, added] = number_.try_emplace(path.string(), -1);
        if (!added) return found->second;
        add_file(path, scene_.files);
        try {
            scene_.textures.push_back(read_texture(path));
            found->second = static_cast<std::int32_t>(scene_.textures.size() - 1);
        } catch (const Error& error) {
            scene_.warnings.push_back(fmt::format("{}; a plain colour is used", error.what()));
        }
        return found->second;
    }

  private:
    Scene& scene_;
    std::unordered_map<std::string, std::int32_t> number_;
};

} // namespace

void read_materials(const RawMesh& raw, const std::string& name,
    const std::filesystem::path& folder, bool has_uv, Scene& scene)
{
    Library library;
    if (!folder.empty()) library = read_libraries(raw, name, folder, scene);

    Textures textures(scene);
    std::string missing;
    std::size_t missing_count = 0;
    for (const std::string& wanted : raw.materials) {
        const auto found = library.find(wanted);
        if (found == library.end()) {
            if (missing_count++ == 0) missing = wanted;
            scene.materials.push_back(default_material());
            scene.materials.back().name = wanted;
            continue;
        }
        const auto& [mtl, library_folder] = found->second;
        Material& made = scene.materials.emplace_back();
        made.name = mtl.name;
        Phong& phong = made.model.emplace<Phong>(mtl.material);
        if (!mtl.texture.empty() && has_uv)
            phong.texture = textures.number(library_folder / mtl.texture);
    }
    if (missing_count > 0)
        scene.warnings.push_back(
            fmt::format("{}: {} materials are in no library ('{}' is one): grey", name,
                missing_count, printable(missing)));
    scene.materials.push_back(default_material());
}

} // namespace firsthit
