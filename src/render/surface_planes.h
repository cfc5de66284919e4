// surface_planes.h - the planes that follow from hits and vertices: tangent, motion, motion_visible.
#pragma once

#include "base/tasks.h"

#include <firsthit/film.h>
#include <firsthit/occlusion.h>
#include <firsthit/scene.h>
#include <firsthit/settings.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace firsthit {

/// Looks up what vertices say at the hits, after any engine has found their items and barycentrics.
class SurfacePlanes {
  public:
    /// Takes these planes out of the settings, and puts in the items and barycentrics that they need.
    void without(Settings& own);

    /// Fills the planes that the last call of without() took away, and takes the barycentrics away
    /// where nobody asked for them.
    ///
    /// view  with its region filled in
    void fill(
        const World& world, const View& view, const Settings& settings, Tasks& tasks, Film& film);

  private:
    void fill_tangents(const World& world, Tasks& tasks, Film& film) const;
    void fill_motion(const World& world, const View& view, const PreviousFrame& previous,
        Tasks& tasks, Film& film);
    void find_visible(const View& view, const PreviousFrame& previous, Tasks& tasks, Film& film);

    bool wants_tangent_ = false;
    bool wants_motion_ = false;
    bool wants_visible_ = false;
    bool wants_barycentric_ = false;
    std::unique_ptr<Occlusion> occlusion_; // made when it is first needed
    std::vector<std::uint32_t> pixel_;     // of the points that may have been visible
    std::vector<std::uint32_t> receiver_;
    std::vector<glm::vec3> point_;
    std::vector<std::uint8_t> occluded_;
};

/// throws  ArgumentError: the frame before is not of the same scene, or its camera is none
void check_previous(const World& world, const View& view, const PreviousFrame& previous);

} // namespace firsthit
