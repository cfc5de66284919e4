// colmap.h - cameras of COLMAP's text files.
#pragma once

#include <firsthit/camera_file.h>

#include <filesystem>
#include <optional>
#include <vector>

namespace firsthit {

/// Reads cameras.txt and images.txt of a folder: a camera for each picture, in the order of images.txt.
/// throws  FileError: names file and line
std::vector<FileCamera> read_colmap(
    const std::filesystem::path& folder, const std::optional<double>& pixel_center);

} // namespace firsthit
