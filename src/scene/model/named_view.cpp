// named_view.cpp - usual directions to look from, and cameras that go round.
#include <firsthit/framing.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <numbers>

namespace firsthit {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kAzimuth = 35 * kDegree;   // of the view iso, from the front to the right
constexpr double kElevation = 25 * kDegree; // of the view iso

} // namespace

Framing named_view(NamedView view, const glm::dvec3& up)
{
    // Where y or x is up, +z is at the front; where z is up, -y.
    const bool z_up = up.z != 0;
    const glm::dvec3 front = z_up ? glm::dvec3(0, -1, 0) : glm::dvec3(0, 0, 1);
    const glm::dvec3 right = glm::cross(up, front);
    Framing framing;
    framing.up = up;
    switch (view) {
    case NamedView::iso:
        framing.towards_eye =
            std::cos(kElevation) * (std::sin(kAzimuth) * right + std::cos(kAzimuth) * front) +
            std::sin(kElevation) * up;
        break;
    case NamedView::front:
        framing.towards_eye = front;
        break;
    case NamedView::back:
        framing.towards_eye = -front;
        break;
    case NamedView::left:
        framing.towards_eye = -right;
        break;
    case NamedView::right:
        framing.towards_eye = right;
        break;
    case NamedView::top:
        framing.towards_eye = up;
        framing.up = -front;
        break;
    case NamedView::bottom:
        framing.towards_eye = -up;
        framing.up = front;
        break;
    }
    return framing;
}

Camera turned_camera(
    const Camera& camera, const glm::dvec3& middle, const glm::dvec3& axis, double angle_rad)
{
    const glm::dquat turn = glm::angleAxis(angle_rad, glm::normalize(axis));
    Camera turned = camera;
    turned.eye = middle + turn * (camera.eye - middle);
    turned.direction = turn * camera.direction;
    turned.up = turn * camera.up;
    return turned;
}

} // namespace firsthit
