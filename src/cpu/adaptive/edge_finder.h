// edge_finder.h - finds the pixels that may hold more than the ray through their centre shows.
#pragma once

#include "base/tasks.h"
#include "cpu/adaptive/edge_memory.h"
#include "cpu/adaptive/pixel_marks.h"
#include "cpu/copy_rows.h"
#include "exact/pencil.h"
#include "frame/frame_context.h"
#include "hits/hit_tile.h"
#include "hits/light_visibility.h"
#include "visibility/bin/view_memory.h"

#include <firsthit/film.h>
#include <firsthit/scene.h>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include <cstddef>
#include <utility>

namespace firsthit {

/// Marks pixels of a picture with one ray a pixel, in three steps that are described at the functions.
/// A pixel's mark depends on the pixels of the same block of 8x8 and on those up to two pixels away,
/// not on threads, on tiles or on how the picture is divided.
///
/// source  Salesin and Stolfi 1989, "The ZZ-Buffer" (more samples where a cell holds more than one
///         surface)
class EdgeFinder {
  public:
    /// How many pixels around it decide on a pixel's mark.
    static constexpr int kAround = 2;

    /// frame  the picture
    /// marks  cleared for the region that is rendered
    EdgeFinder(const FrameContext& frame, EdgeMemory& memory, PixelMarks& marks);

    /// Remembers what the pixels of a tile see. Calls of different workers may overlap.
    ///
    /// hits  with items and misses (HitMemory)
    void record(
        const PixelRect& rect, const HitTile& hits, const LightVisibility& lit, std::size_t worker);

    /// Marks the pixels of a part whose square a triangle touches that is neither behind what the
    /// centre sees, nor goes on with the same surface: triangles that are too small or too thin for
    /// any centre, and tips. Does nothing for layers after the first one.
    ///
    /// view  of the part, after all of its tiles were recorded
    void find_touched(const Region& part, const ViewMemory& view);

    /// Marks neighbours that see different instances, one of them nothing, or surfaces that do not meet.
    ///
    /// What is recorded afterwards is the next layer.
    ///
    /// view  of any part
    void find_neighbours(const ViewMemory& view);

    /// Marks the pixels whose colour is far from the middle of two opposite neighbours of the same
    /// instance in the first layer: creases, highlights, textures, and, sooner, the borders of shadows.
    ///
    /// color  (height, width, 3) linear
    void find_contrast(const Plane& color);

    /// The time of the last two functions but one since the last call, in milliseconds.
    double take_ms() { return std::exchange(ms_, 0); }

  private:
    bool in_first_layer() const { return sight_ == &memory_.first; }
    void record_blocks(const PixelRect& rect, const HitTile& hits);

    /// 1/t in the space of the rays, of what has depth t in the world.
    float inverse_depth(float t) const
    {
        return pencil_.parallel ? float((pencil_.far - double(t)) / pencil_.scale) : 1 / t;
    }

    const World& world_;
    Tasks& tasks_;
    const Pencil pencil_; // of the picture
    EdgeMemory& memory_;
    PixelMarks& marks_;
    EdgeSight* sight_;       // of the layer that is recorded
    glm::vec2 first_ray_{0}; // the direction of the region's first pixel
    double ms_ = 0;
};

} // namespace firsthit
