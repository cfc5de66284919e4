// aff.cpp - reads AFF scenes from the disk.
#include "readers/aff/aff.h"

#include "readers/image/image_file.h"
#include "io/whole_file.h"

#include <firsthit/error.h>

#include <system_error>
#include <utility>

namespace firsthit {

AffFiles aff_files_beside(const std::filesystem::path& path, std::vector<std::string>* opened)
{
    const std::filesystem::path folder = path.parent_path();
    AffFiles files;
    const auto add = [opened](const std::filesystem::path& file) {
        if (opened) add_file(file, *opened);
    };
    files.include_text = [folder, add](const std::string& name) {
        add(folder / name);
        return read_whole_file(folder / name);
    };
    files.texture = [folder, add](const std::string& name) {
        // BART keeps a scene's pictures in a folder beside that of its AFF files.
        const std::filesystem::path beside = folder / ".." / "TextureFiles" / name;
        std::error_code missing;
        const std::filesystem::path found = std::filesystem::exists(beside, missing) &&
                                                    !std::filesystem::exists(folder / name, missing)
                                                ? beside
                                                : folder / name;
        add(found);
        return read_texture(found);
    };
    return files;
}

Scene read_aff(const std::filesystem::path& path, const LoadSettings& settings)
{
    const std::string text = read_whole_file(path);
    std::vector<std::string> opened = {path.string()};
    Scene scene = parse_aff(path.string(), text, aff_files_beside(path, &opened), settings);
    if (scene.index.empty())
        throw FileError(path.string() + ": no triangles in it: there is nothing to show");
    scene.files = std::move(opened);
    return scene;
}

} // namespace firsthit
