// aff.cpp - reads AFF scenes from the disk.
#include "readers/aff/aff.h"

#include "readers/image/image_file.h"
#include "io/whole_file.h"

#include <firsthit/error.h>

#include <system_error>

namespace firsthit {

AffFiles aff_files_beside(const std::filesystem::path& path)
{
    const std::filesystem::path folder = path.parent_path();
    AffFiles files;
    files.include_text = [folder](
                             const std::string& name) { return read_whole_file(folder / name); };
    files.texture = [folder](const std::string& name) {
        // BART keeps a scene's pictures in a folder beside that of its AFF files.
        const std::filesystem::path beside = folder / ".." / "TextureFiles" / name;
        std::error_code missing;
        return read_texture(std::filesystem::exists(beside, missing) &&
                                    !std::filesystem::exists(folder / name, missing)
                                ? beside
                                : folder / name);
    };
    return files;
}

Scene read_aff(const std::filesystem::path& path, const LoadSettings& settings)
{
    const std::string text = read_whole_file(path);
    return parse_aff(path.string(), text, aff_files_beside(path), settings);
}

} // namespace firsthit
