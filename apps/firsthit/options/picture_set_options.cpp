// picture_set_options.cpp - what every command asks that makes pictures: scene, cameras, frames, threads.
#include "options/picture_set_options.h"

#include "common/add_parsed.h"
#include "common/parse.h"
#include "common/usage.h"
#include "inputs/camera_files.h"

#include <firsthit/file.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace firsthit::cli {

bool PictureSetOptions::several() const
{
    return frames.several() || camera.turntable > 0 || camera.cameras.size() > 1;
}

void add_picture_set_options(CLI::App& app, PictureSetOptions& options)
{
    const auto integer = [](int low, int high) {
        return [low, high](const std::string& text) { return parse_integer(text, low, high); };
    };
    CLI::Option* frames = add_frame_choice(app, options.frames);
    add_camera_options(app, options.camera);
    add_camera_file_options(app, options.camera);
    add_parsed(app, "--turntable", options.camera.turntable, integer(1, 100000), "N",
        "N pictures of one turn around the scene, at one time, numbered as by --frames")
        ->excludes(frames);
    add_parsed(app, "--threads", options.threads, integer(0, 1024), "N",
        "Threads, 0 to 1024; default 0: one for each core");
}

void read_files(PictureSetOptions& options)
{
    CameraOptions& camera = options.camera;
    take_cameras(options.scene.pose, camera, options.files);
    if (camera.path && !options.frames.several() && !options.frames.time_s &&
        camera.path->keys.size() > 1)
        options.frames.times = path_times(*camera.path);
}

void check_output_replaces_nothing(
    const PictureSetOptions& options, const Scene& scene, const std::vector<std::string>& outputs)
{
    std::vector<std::string> inputs = scene.files;
    inputs.insert(inputs.end(), options.files.begin(), options.files.end());
    if (!inputs.empty()) firsthit::check_inputs_stay(outputs, inputs);
}

Frames frames_of(const PictureSetOptions& options, const FrameChoice& choice, const Scene& scene,
    const PoseSettings& pose)
{
    Frames frames = frames_of(choice, scene, pose, options.scene.fps);
    const std::size_t cameras = options.camera.cameras.size();
    const bool each = cameras > 1 && !choice.several(); // a picture for each camera
    if (cameras > 1 && choice.several() && frames.size() != cameras)
        throw UsageError(
            fmt::format("--frames has {} times and the file {} cameras: accepted are as many, or "
                        "one camera by --camera-frame",
                frames.size(), cameras));
    for (int k = 1; k < (each ? int(cameras) : options.camera.turntable); ++k) {
        frames.time_s.push_back(frames.time_s[0]);
        frames.number.push_back(k);
    }
    return frames;
}

} // namespace firsthit::cli
