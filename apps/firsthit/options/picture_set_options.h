// picture_set_options.h - what every command asks that makes pictures: scene, cameras, frames, threads.
#pragma once

#include "inputs/frame_choice.h"
#include "options/camera_options.h"
#include "options/scene_options.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace firsthit::cli {

/// Pictures of one scene: of several times, by several cameras, or of one turn around it.
struct PictureSetOptions {
    SceneOptions scene;
    CameraOptions camera;
    FrameChoice frames;             // none chosen: one time
    std::vector<std::string> files; // that options name and that were read
    int threads = 0;

    /// Whether there is more than one picture: --frames, --turntable, or a file with several cameras.
    bool several() const;
};

/// SCENE and its options, --time, --frames, --camera, --camera-frame, --camera-path, --region, the other
/// options of the camera, --turntable, --threads.
void add_picture_set_options(CLI::App& app, PictureSetOptions& options);

/// Reads the files that options name: those of cameras. A path of the camera has frames of its own where none
/// were chosen. To be called before the scene is read.
/// throws  as take_cameras and path_times
void read_files(PictureSetOptions& options);

/// Finds an output that would replace a file that the scene or the cameras were read from.
/// throws  FileError that names both
void check_output_replaces_nothing(
    const PictureSetOptions& options, const Scene& scene, const std::vector<std::string>& outputs);

/// The frames of a scene: those that were chosen, or as many at one time as there are cameras or places of a
/// turntable.
/// choice  as options.frames, or what a command makes of it
/// pose    of the chosen clip, at its begin
/// throws  UsageError: as many times as cameras are accepted, or one camera
Frames frames_of(const PictureSetOptions& options, const FrameChoice& choice, const Scene& scene,
    const PoseSettings& pose);

} // namespace firsthit::cli
