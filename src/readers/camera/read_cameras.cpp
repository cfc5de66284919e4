// read_cameras.cpp - which kind of camera file it is, and cameras for pictures of another size.
#include "io/whole_file.h"
#include "readers/camera/colmap.h"
#include "readers/camera/read_camera_json.h"

#include <firsthit/camera_file.h>
#include <firsthit/error.h>

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace firsthit {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostCameraBytes = std::uintmax_t(1) << 30;

bool ends_with(const std::string& name, std::string_view ending)
{
    return std::string_view(name).ends_with(ending);
}

bool is_colmap_name(const fs::path& path)
{
    return path.filename() == "cameras.txt" || path.filename() == "images.txt";
}

} // namespace

bool is_camera_file(const std::string& name)
{
    std::error_code ignored;
    return ends_with(name, ".json") || is_colmap_name(name) || fs::is_directory(name, ignored);
}

std::vector<FileCamera> read_cameras(
    const std::string& path, const std::optional<double>& pixel_center)
{
    if (pixel_center && *pixel_center != 0 && *pixel_center != 0.5)
        throw ArgumentError(
            fmt::format("pixel centre {:g}: accepted are 0 and 0.5", *pixel_center));
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) return read_colmap(path, pixel_center);
    if (is_colmap_name(path)) return read_colmap(fs::path(path).parent_path(), pixel_center);
    const gltf::Json json =
        gltf::parse_json(read_whole_file(path, kMostCameraBytes), path, "a camera file");
    if (json.is_object() && json.contains("keys"))
        throw FileError(fmt::format("{}: a path of a camera, which --camera-path takes", path));
    if (json.is_object() && json.contains("frames"))
        return read_nerf_cameras(json, path, pixel_center);
    const bool array = json.is_array() && !json.empty();
    if (array || (json.is_object() && json.contains("K")))
        return read_calibrated_cameras(json, path, pixel_center);
    throw FileError(
        fmt::format("{}: no cameras: accepted are an object with K (or an array of such), and "
                    "transforms.json with frames",
            path));
}

Camera resized_camera(const FileCamera& camera, int width, int height)
{
    if (width < 1 || height < 1)
        throw ArgumentError(fmt::format("{} x {} pixels: accepted are at least 1", width, height));
    Camera resized = camera.camera;
    if (camera.angle_x_rad > 0) {
        const double f = 0.5 * width / std::tan(0.5 * camera.angle_x_rad);
        resized.focal = {f, f};
    }
    if (camera.width == 0 || camera.height == 0) return resized;
    if (camera.width == width && camera.height == height) return resized;
    const glm::dvec2 scale(double(width) / camera.width, double(height) / camera.height);
    if (resized.focal) *resized.focal *= scale;
    if (resized.principal_point) *resized.principal_point *= scale;
    resized.skew *= scale.x;
    return resized;
}

} // namespace firsthit
