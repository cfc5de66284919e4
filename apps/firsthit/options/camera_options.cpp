// camera_options.cpp - which eye looks at the scene, and at how many pixels.
#include "options/camera_options.h"

#include "common/add_parsed.h"
#include "common/usage.h"

#include <glm/geometric.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string_view>
#include <utility>

namespace firsthit::cli {

namespace {

bool parallel(const glm::dvec3& a, const glm::dvec3& b)
{
    const double sine = glm::length(glm::cross(glm::normalize(a), glm::normalize(b)));
    return !(sine > 1e-9);
}

constexpr auto kViews =
    std::to_array<std::pair<std::string_view, NamedView>>({{"iso", NamedView::iso},
        {"front", NamedView::front}, {"back", NamedView::back}, {"left", NamedView::left},
        {"right", NamedView::right}, {"top", NamedView::top}, {"bottom", NamedView::bottom}});

double parse_zoom(const std::string& text)
{
    const double zoom = parse_number(text);
    if (1e-3 <= zoom && zoom <= 1e3) return zoom;
    throw UsageError(fmt::format("'{}' is no zoom from 0.001 to 1000", text));
}

/// Things are so many times as large in the picture.
void zoom_in(double zoom, Camera& camera)
{
    if (zoom == 1) return;
    camera.fov_y_rad = 2 * std::atan(std::tan(camera.fov_y_rad / 2) / zoom);
    if (camera.focal) *camera.focal *= zoom;
    if (camera.orthographic_height) *camera.orthographic_height /= zoom;
}

double parse_ortho(const std::string& text)
{
    if (text == "fit") return 0;
    double height = 0;
    try {
        height = parse_number(text);
    } catch (const UsageError&) {
        height = 0; // said below
    }
    if (1e-12 <= height && height <= 1e12) return height;
    throw UsageError(fmt::format(
        "'{}' is no height of an orthographic picture: accepted are 1e-12 to 1e12 world units, and "
        "fit",
        text));
}

/// Makes a camera orthographic, if the options say so.
///
/// far  from its eye to what is to have the same size as before, where the height is to fit
void flatten(const CameraOptions& options, double far, Camera& camera)
{
    if (!options.ortho) return;
    if (options.fov_y_rad || options.intrinsics)
        throw UsageError(
            fmt::format("--ortho and {} exclude each other: parallel rays have no lens",
                options.fov_y_rad ? "--fov" : "--intrinsics"));
    double height = *options.ortho;
    if (height == 0 && camera.orthographic_height) height = *camera.orthographic_height;
    if (height == 0) height = 2 * far * std::tan(camera.fov_y_rad / 2);
    camera.orthographic_height = height;
    camera.focal.reset();
    camera.principal_point.reset();
    camera.skew = 0;
}

double parse_pixel_center(const std::string& text)
{
    const double center = parse_number(text);
    if (center == 0 || center == 0.5) return center;
    throw UsageError(
        fmt::format("'{}' is no pixel centre: accepted are 0 (as OpenCV) and 0.5", text));
}

/// The numbers between commas.
std::vector<double> parse_list(const std::string& text)
{
    std::vector<double> numbers;
    for (std::size_t first = 0;;) {
        const std::size_t end = std::min(text.find(',', first), text.size());
        numbers.push_back(parse_number(text.substr(first, end - first)));
        if (end == text.size()) return numbers;
        first = end + 1;
    }
}

/// The lens of --intrinsics.
void take_intrinsics(const CameraOptions& options, Camera& camera)
{
    if (!options.intrinsics) return;
    const auto& [fx, fy, cx, cy, skew] = *options.intrinsics;
    const double shift = 0.5 - options.pixel_center.value_or(0.5);
    camera.focal = {fx, fy};
    camera.principal_point = {cx + shift, cy + shift};
    camera.skew = skew;
    camera.orthographic_height.reset();
}

} // namespace

Size CameraOptions::pixels(std::size_t number) const
{
    if (size) return *size;
    if (!cameras.empty() && camera(number).width > 0)
        return {camera(number).width, camera(number).height};
    return file_size;
}

std::array<double, 5> parse_intrinsics(const std::string& text)
{
    std::vector<double> n;
    try {
        n = parse_list(text);
    } catch (const UsageError&) {
        n.clear(); // said below
    }
    if ((n.size() == 4 || n.size() == 5) && n[0] > 0 && n[1] > 0)
        return {n[0], n[1], n[2], n[3], n.size() == 5 ? n[4] : 0.0};
    throw UsageError(
        fmt::format("'{}' are no intrinsics: accepted are fx,fy,cx,cy[,skew] in pixels, fx and fy "
                    "above 0, as 800,800,320,240",
            text));
}

Region parse_region(const std::string& text)
{
    constexpr double kMost = 65536;
    std::vector<double> n;
    try {
        n = parse_list(text);
    } catch (const UsageError&) {
        n.clear(); // said below
    }
    const auto whole = [&](double v, double least) {
        return v == std::floor(v) && least <= v && v <= kMost;
    };
    if (n.size() == 4 && whole(n[0], 0) && whole(n[1], 0) && whole(n[2], 1) && whole(n[3], 1))
        return {int(n[0]), int(n[1]), int(n[2]), int(n[3])};
    throw UsageError(
        fmt::format("'{}' is no region: accepted is x,y,width,height in whole pixels from the "
                    "picture's top left, as 0,0,320,240",
            text));
}

glm::dvec3 usual_up_axis(const std::string& scene)
{
    std::string ending = std::filesystem::path(scene).extension().string();
    for (char& c : ending)
        if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    const bool z_up = ending == ".stl" || ending == ".ply" || ending == ".3mf";
    return z_up ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
}

NamedView parse_view(const std::string& text)
{
    for (const auto& [name, view] : kViews)
        if (text == name) return view;
    throw UsageError(fmt::format(
        "'{}' is no view: accepted are iso, front, back, left, right, top and bottom", text));
}

glm::dvec3 parse_axis(const std::string& text)
{
    const bool negative = !text.empty() && text[0] == '-';
    const std::string_view name = std::string_view(text).substr(negative ? 1 : 0);
    const double sign = negative ? -1 : 1;
    if (name == "x") return {sign, 0, 0};
    if (name == "y") return {0, sign, 0};
    if (name == "z") return {0, 0, sign};
    throw UsageError(fmt::format("'{}' is no axis: accepted are x, y, z, -x, -y and -z", text));
}

void add_camera_options(CLI::App& app, CameraOptions& options)
{
    add_parsed(app, "--size", options.size, parse_size, "WxH",
        "Pixels, each side 1 to 65536; default what the file asks for (AFF, NFF), or 1024x1024");
    add_parsed(app, "--view", options.view, parse_view, "NAME",
        "iso, front, back, left, right, top or bottom: all of the scene from there; default the "
        "scene's camera, or iso where it has none");
    add_parsed(app, "--zoom", options.zoom, parse_zoom, "X",
        "How many times as large things are in the picture, 0.001 to 1000; default 1");
    add_parsed(app, "--up-axis", options.up_axis, parse_axis, "AXIS",
        "What is up in the file: x, y, z, -x, -y or -z; default z for .stl, .ply and .3mf where "
        "the model does not "
        "rest on a flat bottom along y, else y");
    add_parsed(app, "--eye", options.eye, parse_vector, "x,y,z",
        "Where the eye is. Without --at, the scene's own camera moves without turning; a scene "
        "without a camera is looked at in its middle");
    add_parsed(app, "--at", options.at, parse_vector, "x,y,z", "A point that the eye looks at");
    add_parsed(app, "--up", options.up, parse_vector, "x,y,z",
        "What is up in the picture; default the camera's, or 0,0,-1 when it looks along that");
    add_parsed(app, "--fov", options.fov_y_rad, parse_fov, "DEG",
        "Full vertical angle, above 0 and below 180");
    add_parsed(app, "--ortho", options.ortho, parse_ortho, "HEIGHT|fit",
        "An orthographic camera: the height of the picture in world units, or fit: as large as the "
        "scene was in perspective. What is behind the eye is not seen. On the cpu engine");
    add_parsed(app, "--intrinsics", options.intrinsics, parse_intrinsics, "fx,fy,cx,cy[,skew]",
        "The lens of a calibrated camera, in pixels of the picture");
    add_parsed(app, "--pixel-center", options.pixel_center, parse_pixel_center, "0|0.5",
        "Where --intrinsics or a camera's file has the centre of pixel (0, 0); default 0.5, of "
        "files as "
        "they say");
}

void take_size(const Scene& scene, CameraOptions& options)
{
    if (scene.picture_size != glm::ivec2(0))
        options.file_size = {scene.picture_size.x, scene.picture_size.y};
}

Camera override_camera(
    const Camera& camera, const CameraOptions& options, const std::optional<glm::dvec3>& middle)
{
    Camera result = camera;
    if (options.eye) result.eye = *options.eye;
    if (options.at)
        result.direction = *options.at - result.eye;
    else if (options.eye && middle)
        result.direction = *middle - result.eye;
    if (result.direction == glm::dvec3(0))
        throw UsageError("the eye and the point that it looks at coincide: move --eye or --at");
    if (options.up) result.up = *options.up;
    if (options.up && (result.up == glm::dvec3(0) || parallel(result.direction, result.up)))
        throw UsageError("--up is parallel to the direction of view: choose another");
    const bool turned = options.eye || options.at;
    if (!options.up && turned && parallel(result.direction, result.up)) result.up = {0, 0, -1};
    if (options.fov_y_rad) {
        result.fov_y_rad = *options.fov_y_rad;
        result.focal.reset();
        result.orthographic_height.reset();
    }
    const double far = middle ? glm::length(*middle - result.eye) : glm::length(result.direction);
    flatten(options, far, result);
    return result;
}

/// The camera of --view, or of a scene that has none.
void ViewMaker::frame(const World& world)
{
    const std::array<glm::vec3, 2> box = bounds(world);
    middle_ = (glm::dvec3(box[0]) + glm::dvec3(box[1])) * 0.5;
    if (!options_.up_axis && up_axis_.z > 0) up_axis_ = upward_axis(world, up_axis_);
    if (!options_.view && !world.scene->cameras.empty()) return;
    Framing framing = named_view(options_.view.value_or(NamedView::iso), up_axis_);
    framing.aspect = static_cast<double>(options_.pixels().width) / options_.pixels().height;
    if (options_.intrinsics) {
        const auto& [fx, fy, cx, cy, skew] = *options_.intrinsics;
        framing.fov_y_rad = 2 * std::atan(0.5 * options_.pixels().height / fy);
        framing.aspect *= fy / fx;
    }
    framing.all_around = options_.turntable > 0;
    framing.orthographic = options_.ortho.has_value();
    framing_ = framing_camera(world, framing);
}

View ViewMaker::view(World& world, std::size_t number)
{
    if (!middle_) frame(world);
    View view;
    const Size size = options_.pixels(number);
    if (!options_.cameras.empty())
        view.camera = resized_camera(options_.camera(number), size.width, size.height);
    else if (options_.path)
        view.camera = camera_at(*options_.path, world.time_s);
    else
        view.camera = override_camera(framing_ ? *framing_ : world.camera, options_,
            framing_ || options_.ortho ? middle_ : std::optional<glm::dvec3>());
    take_intrinsics(options_, view.camera);
    zoom_in(options_.zoom, view.camera);
    if (options_.turntable > 0)
        view.camera = turned_camera(view.camera, *middle_, up_axis_,
            2 * std::numbers::pi * static_cast<double>(number) / options_.turntable);
    view.width = size.width;
    view.height = size.height;
    view.region = options_.region;
    hang_lights(view.camera, world);
    return view;
}

} // namespace firsthit::cli
