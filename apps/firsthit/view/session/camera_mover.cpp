// camera_mover.cpp - moves a camera as a hand asks.
#include "view/session/camera_mover.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace firsthit::cli::view {
namespace {

/// How near to the upright axis the camera may look: beyond it the picture would spin.
constexpr double kPoleRad = 0.02;
/// A camera that is turned past this much of an angle to the axis is asked not to.
constexpr double kLeastSize = 1e-9;

std::string spelled(const glm::dvec3& v)
{
    return fmt::format("{},{},{}", v.x, v.y, v.z);
}

double radius_of(const Box& box)
{
    return std::max(kLeastSize, glm::length(box[1] - box[0]) / 2);
}

glm::dvec3 middle_of(const Box& box)
{
    return (box[0] + box[1]) * 0.5;
}

} // namespace

void CameraMover::take(const Camera& camera, const Box& box, const glm::dvec3& up_axis, int height)
{
    const glm::dvec3 forward = glm::normalize(camera.direction);
    double far = glm::dot(middle_of(box) - camera.eye, forward);
    const double least = 0.05 * radius_of(box);
    if (!(far > least)) far = std::max(least, radius_of(box));
    eye_ = camera.eye;
    at_ = eye_ + forward * far;
    ortho_height_ = camera.orthographic_height.value_or(0);
    fov_deg_ = camera.fov_y_rad * 180 / std::numbers::pi;
    if (camera.focal)
        fov_deg_ = 2 * std::atan(0.5 * height / camera.focal->y) * 180 / std::numbers::pi;
    // A camera that is nearly upright becomes upright; one that is tilted keeps its own axis.
    const glm::dvec3 side = glm::cross(forward, camera.up), upright = glm::cross(forward, up_axis);
    const bool defined = glm::length(upright) > 1e-6 * glm::length(up_axis);
    const bool same = defined && glm::length(side) > 0 &&
                      glm::dot(glm::normalize(side), glm::normalize(upright)) > 0.999;
    up_ = same ? glm::normalize(up_axis) : glm::normalize(camera.up);
}

void CameraMover::focus(double far, const Box& box)
{
    if (!(far > 0) || glm::length(middle_of(box) - eye_) > radius_of(box)) return;
    at_ = eye_ + glm::normalize(at_ - eye_) * far;
}

std::array<glm::dvec3, 3> CameraMover::axes() const
{
    const glm::dvec3 forward = glm::normalize(at_ - eye_);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, up_));
    return {right, glm::cross(right, forward), forward};
}

glm::dvec3 CameraMover::turned(const glm::dvec3& v, double right_rad, double up_rad) const
{
    const glm::dvec3 right = axes()[0];
    const double angle = std::acos(std::clamp(glm::dot(glm::normalize(v), up_), -1.0, 1.0));
    const double most = std::max(0.0, angle - kPoleRad);
    const double least = std::min(0.0, angle - std::numbers::pi + kPoleRad);
    // Positive turns towards the upright axis.
    const double tilt = std::clamp(up_rad, least, most);
    const glm::dvec3 axis = glm::cross(v, up_);
    const glm::dvec3 unit =
        glm::length(axis) > 1e-12 * glm::length(v) ? glm::normalize(axis) : right;
    const glm::dvec3 tilted = glm::angleAxis(tilt, unit) * v;
    return glm::angleAxis(right_rad, up_) * tilted;
}

void CameraMover::orbit(double right_rad, double up_rad)
{
    eye_ = at_ + turned(eye_ - at_, right_rad, up_rad);
}

void CameraMover::look(double right_rad, double up_rad)
{
    at_ = eye_ + turned(at_ - eye_, right_rad, up_rad);
}

void CameraMover::pan(const glm::dvec2& moved)
{
    const auto [right, up, forward] = axes();
    const glm::dvec3 step = (right * -moved.x + up * moved.y) * height();
    eye_ += step;
    at_ += step;
}

void CameraMover::zoom(double factor, const glm::dvec2& pointer)
{
    const auto [right, up, forward] = axes();
    const glm::dvec3 p = at_ + (right * pointer.x - up * pointer.y) * height();
    if (ortho_height_ > 0) {
        // The eye keeps its distance: nothing is to fall behind it.
        const glm::dvec3 moved = (p - at_) * (1 - factor);
        eye_ += moved;
        at_ += moved;
        ortho_height_ = std::clamp(ortho_height_ * factor, 1e-12, 1e12);
        return;
    }
    eye_ = p + (eye_ - p) * factor;
    at_ = p + (at_ - p) * factor;
}

void CameraMover::fly(const glm::dvec3& moved)
{
    const auto [right, up, forward] = axes();
    const glm::dvec3 step = (right * moved.x + up * moved.y + forward * moved.z) * distance();
    eye_ += step;
    at_ += step;
}

void CameraMover::frame(
    const Box& box, const glm::dvec3& towards_eye, const glm::dvec3& up, double aspect)
{
    if (ortho_height_ > 0) {
        const double radius = radius_of(box);
        ortho_height_ = 2 * 1.05 * radius / std::min(1.0, aspect);
        at_ = middle_of(box);
        eye_ = at_ + glm::normalize(towards_eye) * (2 * radius);
        up_ = glm::normalize(up);
        return;
    }
    const double half = camera().fov_y_rad / 2;
    const double across = std::atan(std::tan(half) * aspect);
    at_ = middle_of(box);
    eye_ = at_ +
           glm::normalize(towards_eye) * (1.05 * radius_of(box) / std::sin(std::min(half, across)));
    up_ = glm::normalize(up);
}

void CameraMover::frame(const Box& box, double aspect)
{
    frame(box, eye_ - at_, up_, aspect);
}

Camera CameraMover::camera() const
{
    Camera camera;
    camera.eye = eye_;
    camera.direction = at_ - eye_; // as --at is understood
    camera.up = up_;
    camera.fov_y_rad = fov_deg_ * (3.14159265358979323846 / 180); // as --fov is, to the bit
    if (ortho_height_ > 0) camera.orthographic_height = ortho_height_;
    return camera;
}

double CameraMover::height() const
{
    return ortho_height_ > 0 ? ortho_height_ : 2 * distance() * std::tan(camera().fov_y_rad / 2);
}

double CameraMover::distance() const
{
    return glm::length(at_ - eye_);
}

std::string CameraMover::as_options() const
{
    const std::string lens = ortho_height_ > 0 ? fmt::format("--ortho {}", ortho_height_)
                                               : fmt::format("--fov {}", fov_deg_);
    return fmt::format(
        "--eye {} --at {} --up {} {}", spelled(eye_), spelled(at_), spelled(up_), lens);
}

} // namespace firsthit::cli::view
