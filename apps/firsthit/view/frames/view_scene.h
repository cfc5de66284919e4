// view_scene.h - a scene that is looked at: read, lit, and with the camera that it starts with.
#pragma once

#include "inputs/scene_source.h"
#include "options/render_options.h"
#include "view/frames/box.h"

#include <firsthit/world.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace firsthit::cli::view {

/// Immutable but for the source, which one thread at a time may ask.
class ViewScene {
  public:
    /// Reads the scene as `render` does.
    /// throws  as render, for the scene
    explicit ViewScene(const RenderOptions& options);

    /// What the options say after files that they name were read.
    const RenderOptions& options() const { return options_; }
    /// The scene of the first frame, with all clips, cameras and names.
    const Scene& first() const { return *first_; }
    /// The scene of a time. throws  as SceneSequence::scene_at
    std::shared_ptr<const Scene> scene_at(double time_s);

    /// What `render` shows of a posed world, in a picture of another size. Lights on the camera go along.
    /// camera  in the place of the one that the options or the file say; or null
    View view(World& world, int width, int height, const Camera* camera);

    /// Settings of the picture at rest.
    Settings settings() const;
    bool in_studio() const { return studio_; }
    bool is_numbered() const { return numbered_; }
    double begin_s(std::int32_t clip) const;
    double end_s(std::int32_t clip) const;
    const PoseSettings& start() const { return start_; }
    const Camera& start_camera() const { return start_camera_; }
    const Box& box() const { return box_; }
    const glm::dvec3& up_axis() const { return up_axis_; }

    /// Whether a file that it was read from has another time than when it was read, or than at note_times().
    bool has_changed() const;
    void note_times();

  private:
    RenderOptions options_;
    bool studio_ = false, numbered_ = false;
    double end_s_ = 0;
    std::mutex mutex_; // of source_ and views_
    std::unique_ptr<SceneSource> source_;
    std::unique_ptr<ViewMaker> views_;
    std::shared_ptr<const Scene> first_;
    PoseSettings start_;
    Camera start_camera_;
    Box box_{};
    glm::dvec3 up_axis_{0, 1, 0};
    std::map<std::string, std::filesystem::file_time_type> times_; // of files, when they were read
};

} // namespace firsthit::cli::view
