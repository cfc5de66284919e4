// surface_planes.cpp - the planes that follow from hits and vertices: tangent, motion, motion_visible.
#include "render/surface_planes.h"

#include "base/large_pages.h"
#include "exact/pencil.h"

#include <firsthit/error.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace firsthit {
namespace {

constexpr std::size_t kPixelsOfSurfaceTask = 16384;

/// Takes a plane out. Returns whether it was there.
bool take(std::vector<Aov>& aovs, Aov aov)
{
    return std::erase(aovs, aov) > 0;
}

/// Puts a plane in where it is missing. Returns whether it was there.
bool ensure(std::vector<Aov>& aovs, Aov aov)
{
    if (std::find(aovs.begin(), aovs.end(), aov) != aovs.end()) return true;
    aovs.push_back(aov);
    return false;
}

void resize(Plane& plane, Aov aov, std::size_t pixels)
{
    plane.channels = aov_channels(aov);
    resize_in_large_pages(plane.value, pixels * std::size_t(plane.channels));
}

/// Calls f(pixel) for each pixel of the film, on all threads.
template <class F>
void for_pixels(const Film& film, Tasks& tasks, const F& f)
{
    tasks.for_ranges(
        film.item.size(), kPixelsOfSurfaceTask, [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last; ++k) f(k);
        });
}

/// The point of a triangle at a pixel's barycentrics, in a pose.
glm::dvec3 point_of(const World& world, const Film& film, std::size_t pixel)
{
    const glm::uvec3& corner = world.scene->index[film.item[pixel]];
    const float* const weight = &film[Aov::barycentric].value[2 * pixel];
    const glm::dvec3 p0(world.position[corner.x]);
    const glm::dvec3 e1 = glm::dvec3(world.position[corner.y]) - p0;
    const glm::dvec3 e2 = glm::dvec3(world.position[corner.z]) - p0;
    return p0 + (double(weight[0]) * e1 + double(weight[1]) * e2);
}

/// The rays of a whole picture.
Pencil whole(View view)
{
    view.region = {0, 0, view.width, view.height};
    return pencil_of(view, view.region, 1);
}

/// Where a picture shows a point, pixels from its top left; none where it is not before the eye.
std::optional<glm::dvec2> place_in(const Pencil& picture, const glm::dvec3& point)
{
    const glm::dvec3 p = picture.eye_from_world * (point - picture.eye);
    if (!(p.z > 0)) return {};
    const glm::dvec2 seen = picture.parallel ? glm::dvec2(p) : glm::dvec2(p) / p.z;
    const glm::dvec2 place(seen.x - picture.x0 + 0.5, seen.y - picture.y0 + 0.5);
    if (!std::isfinite(place.x) || !std::isfinite(place.y)) return {};
    return place;
}

} // namespace

void check_previous(const World& world, const View& view, const PreviousFrame& previous)
{
    if (!previous.world) return;
    const World& before = *previous.world;
    if (!before.scene || before.scene->index.size() != world.scene->index.size() ||
        before.scene->instances.size() != world.scene->instances.size() ||
        before.node_visible.size() != world.node_visible.size())
        throw ArgumentError(
            "the previous frame's world is not a pose of this frame's scene: it has "
            "other triangles, instances or nodes");
    View picture = view;
    picture.camera = previous.camera;
    whole(picture); // checks the camera
}

void SurfacePlanes::without(Settings& own)
{
    wants_tangent_ = take(own.aovs, Aov::tangent);
    wants_motion_ = take(own.aovs, Aov::motion);
    wants_visible_ = take(own.aovs, Aov::motion_visible);
    wants_barycentric_ = true;
    if (!wants_tangent_ && !wants_motion_ && !wants_visible_) return;
    ensure(own.aovs, Aov::item); // see IdPlanes, which takes it away again
    wants_barycentric_ = ensure(own.aovs, Aov::barycentric);
}

void SurfacePlanes::fill(
    const World& world, const View& view, const Settings& settings, Tasks& tasks, Film& film)
{
    if (wants_tangent_) fill_tangents(world, tasks, film);
    if (wants_motion_ || wants_visible_) fill_motion(world, view, settings.previous, tasks, film);
    if (!wants_barycentric_) film[Aov::barycentric].value.clear();
}

void SurfacePlanes::fill_tangents(const World& world, Tasks& tasks, Film& film) const
{
    Plane& plane = film[Aov::tangent];
    resize(plane, Aov::tangent, film.item.size());
    const bool has = world.tangent.size() >= world.position.size();
    for_pixels(film, tasks, [&](std::size_t k) {
        glm::vec4 tangent(0);
        if (has && film.item[k] != kNoItem) {
            const glm::uvec3& corner = world.scene->index[film.item[k]];
            const float* const weight = &film[Aov::barycentric].value[2 * k];
            const glm::vec4 t0 = world.tangent[corner.x];
            const glm::dvec3 t(
                glm::dvec3(t0) + (double(weight[0]) * glm::dvec3(world.tangent[corner.y] - t0) +
                                     double(weight[1]) * glm::dvec3(world.tangent[corner.z] - t0)));
            const double length = glm::length(t);
            if (length > 1e-6) tangent = glm::vec4(glm::vec3(t / length), t0.w);
        }
        std::copy_n(&tangent.x, 4, &plane.value[4 * k]);
    });
}

void SurfacePlanes::fill_motion(
    const World& world, const View& view, const PreviousFrame& previous, Tasks& tasks, Film& film)
{
    const std::size_t pixels = film.item.size();
    Plane& motion = film[Aov::motion];
    Plane& visible = film[Aov::motion_visible];
    if (wants_motion_) resize(motion, Aov::motion, pixels);
    if (wants_visible_) resize(visible, Aov::motion_visible, pixels);
    View before_view = view;
    before_view.camera = previous.camera;
    const Pencil now = whole(view);
    const Pencil before = previous.world ? whole(before_view) : now;
    const Scene& scene = *world.scene;
    for_pixels(film, tasks, [&](std::size_t k) {
        glm::dvec2 moved(0);
        bool seen = film.item[k] != kNoItem;
        if (seen && previous.world) {
            const std::uint32_t node = scene.instances[scene.owner[film.item[k]]].node;
            std::optional<glm::dvec2> to, from;
            const std::vector<std::uint8_t>& visible_then = previous.world->node_visible;
            if (node >= visible_then.size() || visible_then[node]) {
                // Both by the same weights: what stands still moves by exactly 0.
                to = place_in(now, point_of(world, film, k));
                from = place_in(before, point_of(*previous.world, film, k));
            }
            seen = to && from;
            if (seen) moved = *to - *from;
            seen = seen && from->x >= 0 && from->y >= 0 && from->x < view.width &&
                   from->y < view.height;
        }
        if (wants_motion_)
            for (int axis = 0; axis < 2; ++axis)
                motion.value[2 * k + std::size_t(axis)] = float(moved[axis]);
        if (wants_visible_) visible.value[k] = seen ? 1.0f : 0.0f;
    });
    if (wants_visible_ && previous.world) find_visible(before_view, previous, tasks, film);
}

/// Of the points that were in the picture, finds those that nothing was before.
void SurfacePlanes::find_visible(
    const View& view, const PreviousFrame& previous, Tasks& tasks, Film& film)
{
    Plane& visible = film[Aov::motion_visible];
    pixel_.clear(), receiver_.clear(), point_.clear();
    for (std::size_t k = 0; k < film.item.size(); ++k) {
        if (visible.value[k] == 0) continue;
        pixel_.push_back(std::uint32_t(k));
        receiver_.push_back(film.item[k]);
        point_.emplace_back(point_of(*previous.world, film, k));
    }
    // What an eye sees is what a lamp in its place lights.
    if (!occlusion_) occlusion_ = std::make_unique<Occlusion>(tasks.threads());
    Light eye;
    eye.position = view.camera.eye;
    if (view.camera.orthographic_height) {
        eye.kind = Light::Kind::directional;
        eye.direction = view.camera.direction;
    }
    occlusion_->test(*previous.world, point_, eye, occluded_, receiver_);
    for (std::size_t k = 0; k < pixel_.size(); ++k)
        if (occluded_[k]) visible.value[pixel_[k]] = 0;
}

} // namespace firsthit
