// colmap.cpp - cameras of COLMAP's text files.
//
// source  COLMAP's documentation, "Output Format" and "Camera Models" (colmap.github.io)
#include "readers/camera/colmap.h"

#include "io/parse_number.h"
#include "io/text_cursor.h"
#include "io/whole_file.h"
#include "readers/camera/camera_lens.h"
#include "readers/camera/camera_pose.h"

#include <firsthit/error.h>

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>

namespace firsthit {
namespace {

constexpr std::uintmax_t kMostBytes = std::uintmax_t(1) << 31;

/// A camera model: how many of its first parameters are focal lengths, then two of the principal point, then
/// distortion.
struct ColmapModel {
    std::string_view name;
    std::size_t focals, distortions;
};

constexpr std::array kModels = {ColmapModel{"SIMPLE_PINHOLE", 1, 0}, ColmapModel{"PINHOLE", 2, 0},
    ColmapModel{"SIMPLE_RADIAL", 1, 1}, ColmapModel{"RADIAL", 1, 2}, ColmapModel{"OPENCV", 2, 4},
    ColmapModel{"FULL_OPENCV", 2, 8}};

double number_of(TextCursor& text, const char* what)
{
    const std::string_view word = text.next_word();
    const std::optional<double> value = parse_number(word);
    if (!value || !std::isfinite(*value))
        text.fail(fmt::format("{}: '{}' is no finite number", what, printable(word)));
    return *value;
}

int size_of(TextCursor& text, const char* what)
{
    const std::int64_t value = text.integer(what);
    if (value < 1 || value > 65536)
        text.fail(fmt::format("{} {} is out of range: 1 to 65536 pixels", what, value));
    return static_cast<int>(value);
}

/// Goes to the next line that has words and is no comment.
bool next_record(TextCursor& text)
{
    while (text.next_line()) {
        TextCursor line = text;
        const std::string_view word = line.next_word();
        if (!word.empty() && word[0] != '#') return true;
    }
    return false;
}

FileCamera read_camera(TextCursor& text, double pixel_center)
{
    const std::string_view name = text.next_word();
    const ColmapModel* model = nullptr;
    for (const ColmapModel& known : kModels)
        if (known.name == name) model = &known;
    if (!model)
        text.fail(fmt::format(
            "the camera model '{}' is not known: accepted are SIMPLE_PINHOLE, PINHOLE, and, "
            "without distortion, SIMPLE_RADIAL, RADIAL, OPENCV and FULL_OPENCV",
            printable(name)));
    FileCamera made;
    made.width = size_of(text, "the width");
    made.height = size_of(text, "the height");
    CameraLens lens;
    lens.fx = number_of(text, "the focal length");
    lens.fy = model->focals == 2 ? number_of(text, "the focal length") : lens.fx;
    lens.cx = number_of(text, "the principal point");
    lens.cy = number_of(text, "the principal point");
    const std::string place = fmt::format("{}:{}", text.name(), text.line());
    for (std::size_t k = 0; k < model->distortions; ++k) {
        const double coefficient = number_of(text, "the distortion");
        check_undistorted({&coefficient, 1}, place);
    }
    text.expect_end();
    set_lens(lens, pixel_center, place, made.camera);
    return made;
}

std::map<std::int64_t, FileCamera> read_cameras_txt(
    const std::filesystem::path& path, double pixel_center)
{
    const std::string bytes = read_whole_file(path, kMostBytes);
    TextCursor text(bytes, path.string());
    std::map<std::int64_t, FileCamera> cameras;
    while (next_record(text)) {
        const std::int64_t id = text.integer("the camera's number");
        if (!cameras.emplace(id, read_camera(text, pixel_center)).second)
            text.fail(fmt::format("there is a camera {} already", id));
    }
    return cameras;
}

/// The pose after the picture's number: a quaternion w, x, y, z and a translation, world to camera.
CameraPose read_pose(TextCursor& text)
{
    glm::dquat turn(1, 0, 0, 0);
    turn.w = number_of(text, "the quaternion");
    turn.x = number_of(text, "the quaternion");
    turn.y = number_of(text, "the quaternion");
    turn.z = number_of(text, "the quaternion");
    const double length = glm::length(turn);
    if (!(std::abs(length - 1) <= 1e-3))
        text.fail(fmt::format("the quaternion's length is {:g}: accepted is 1", length));
    CameraPose to_camera{glm::mat3_cast(glm::normalize(turn)), {}};
    to_camera.eye.x = number_of(text, "the translation");
    to_camera.eye.y = number_of(text, "the translation");
    to_camera.eye.z = number_of(text, "the translation");
    checked_shift(to_camera.eye, fmt::format("{}:{}", text.name(), text.line()));
    return inverse(to_camera);
}

} // namespace

std::vector<FileCamera> read_colmap(
    const std::filesystem::path& folder, const std::optional<double>& pixel_center)
{
    const std::filesystem::path cameras_txt = folder / "cameras.txt",
                                images_txt = folder / "images.txt";
    std::error_code ignored;
    if (!std::filesystem::exists(cameras_txt, ignored) &&
        std::filesystem::exists(folder / "cameras.bin", ignored))
        throw FileError(
            fmt::format("{}: COLMAP's binary files are not read: make text of them by `colmap "
                        "model_converter --output_type TXT`",
                folder.string()));
    if (!std::filesystem::exists(cameras_txt, ignored))
        throw FileError(
            fmt::format("{}: a folder of cameras has COLMAP's cameras.txt and images.txt; there "
                        "is no cameras.txt",
                folder.string()));
    const std::map<std::int64_t, FileCamera> lenses =
        read_cameras_txt(cameras_txt, pixel_center.value_or(0.5));
    const std::string bytes = read_whole_file(images_txt, kMostBytes);
    TextCursor text(bytes, images_txt.string());
    std::vector<FileCamera> cameras;
    while (next_record(text)) {
        (void)text.integer("the picture's number");
        const CameraPose pose = read_pose(text);
        const std::int64_t id = text.integer("the camera's number");
        const auto lens = lenses.find(id);
        if (lens == lenses.end())
            text.fail(fmt::format("there is no camera {} in {}", id, cameras_txt.string()));
        FileCamera made = lens->second;
        made.name = text.rest_of_line();
        place_camera(pose, CameraAxes::opencv, made.camera);
        cameras.push_back(made);
        text.next_line(); // of points, which may be empty
    }
    if (cameras.empty()) throw FileError(fmt::format("{}: no picture", images_txt.string()));
    return cameras;
}

} // namespace firsthit
