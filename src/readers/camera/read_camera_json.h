// read_camera_json.h - cameras from JSON: ours with K, and transforms.json of NeRF datasets.
#pragma once

#include "readers/gltf/document/json_text.h"

#include <firsthit/camera_file.h>

#include <optional>
#include <string>
#include <vector>

namespace firsthit {

/// An object with K, or an array of such.
std::vector<FileCamera> read_calibrated_cameras(
    const gltf::Json& json, const std::string& file, const std::optional<double>& pixel_center);

/// An object with frames.
std::vector<FileCamera> read_nerf_cameras(
    const gltf::Json& json, const std::string& file, const std::optional<double>& pixel_center);

} // namespace firsthit
