// camera_planes.cpp - planes in the camera's frame: normal_camera, position_camera.
#include "render/camera_planes.h"

#include "base/large_pages.h"
#include "exact/pencil.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace firsthit {
namespace {

constexpr std::size_t kRowsPerTask = 16;

/// Puts a plane in where it is missing. Returns whether it was there.
bool need(std::vector<Aov>& aovs, Aov aov)
{
    if (std::find(aovs.begin(), aovs.end(), aov) != aovs.end()) return true;
    aovs.push_back(aov);
    return false;
}

/// Makes a plane of three channels, of f(x, y, pixel).
template <class F>
void make_plane(Film& film, Aov aov, Tasks& tasks, const F& f)
{
    Plane& plane = film[aov];
    plane.channels = 3;
    const auto width = std::size_t(film.width), height = std::size_t(film.height);
    resize_in_large_pages(plane.value, width * height * 3);
    tasks.for_ranges(height, kRowsPerTask, [&](std::size_t first, std::size_t last) {
        for (std::size_t y = first; y < last; ++y) {
            for (std::size_t x = 0; x < width; ++x) {
                const std::size_t pixel = y * width + x;
                const glm::vec3 value(f(double(x), double(y), pixel));
                for (int c = 0; c < 3; ++c) plane.value[3 * pixel + std::size_t(c)] = value[c];
            }
        }
    });
}

} // namespace

void CameraPlanes::without(Settings& own)
{
    wants_normal_ = std::erase(own.aovs, Aov::normal_camera) > 0;
    wants_position_ = std::erase(own.aovs, Aov::position_camera) > 0;
    had_normal_ = !wants_normal_ || need(own.aovs, Aov::normal);
    had_depth_ = !wants_position_ || need(own.aovs, Aov::depth);
}

void CameraPlanes::fill(const View& view, Tasks& tasks, Film& film) const
{
    if (!wants_normal_ && !wants_position_) return;
    const Pencil pencil = pencil_of(view, view.region, 1);
    if (wants_normal_) {
        const glm::dvec3 forward = glm::normalize(view.camera.direction);
        const glm::dvec3 right = glm::normalize(glm::cross(view.camera.direction, view.camera.up));
        const glm::dvec3 down = glm::cross(forward, right);
        const std::vector<float>& world = film[Aov::normal].value;
        make_plane(film, Aov::normal_camera, tasks, [&](double, double, std::size_t pixel) {
            const glm::dvec3 n(world[3 * pixel], world[3 * pixel + 1], world[3 * pixel + 2]);
            return glm::dvec3(glm::dot(n, right), glm::dot(n, down), glm::dot(n, forward));
        });
    }
    if (wants_position_) {
        const std::vector<float>& depth = film[Aov::depth].value;
        const glm::dvec3 shear = pencil.shear;
        make_plane(film, Aov::position_camera, tasks, [&](double x, double y, std::size_t pixel) {
            const double z = depth[pixel];
            if (!std::isfinite(z)) return glm::dvec3(0);
            const double along_x = (pencil.x0 + x) / pencil.f.x,
                         along_y = (pencil.y0 + y) / pencil.f.y;
            if (pencil.parallel) return glm::dvec3(along_x, along_y, z);
            return z * glm::dvec3(along_x + along_y * shear.x + shear.y, along_y + shear.z, 1);
        });
    }
    if (!had_normal_) film[Aov::normal].value.clear();
    if (!had_depth_) film[Aov::depth].value.clear();
}

} // namespace firsthit
