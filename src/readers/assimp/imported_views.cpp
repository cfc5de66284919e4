// imported_views.cpp - the cameras and lights of what Assimp has read.
#include "readers/assimp/convert.h"
#include "readers/assimp/imported_scene.h"

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace firsthit {
namespace {

bool has_direction(const glm::dvec3& v)
{
    const double length = glm::length(v);
    return length > 1e-12 && std::isfinite(length);
}

/// Assimp gives a full horizontal angle. Without an aspect ratio the picture is square.
std::optional<double> vertical_angle(const aiCamera& from)
{
    const double aspect = from.mAspect > 0 && std::isfinite(from.mAspect) ? from.mAspect : 1;
    const double half = std::tan(double(from.mHorizontalFOV) / 2) / aspect;
    if (!(from.mHorizontalFOV > 0 && from.mHorizontalFOV < std::numbers::pi_v<float>) ||
        !(half > 0 && half < 1e6))
        return std::nullopt;
    return 2 * std::atan(half);
}

/// The kind of a light; nothing where it cannot be shown.
std::optional<Light::Kind> kind_of(aiLightSourceType type)
{
    if (type == aiLightSource_DIRECTIONAL) return Light::Kind::directional;
    if (type == aiLightSource_POINT) return Light::Kind::point;
    if (type == aiLightSource_SPOT) return Light::Kind::spot;
    return std::nullopt;
}

void set_cone(const aiLight& from, Light& light)
{
    static constexpr double kWidest = 1.5; // radians: below pi / 2, where a cone ends
    const auto half = [](float full) {
        return std::isfinite(full) ? std::clamp(double(full) / 2, 0.0, kWidest) : kWidest;
    };
    light.outer_rad = std::max(half(from.mAngleOuterCone), 1e-3);
    light.inner_rad = std::min(half(from.mAngleInnerCone), light.outer_rad);
}

} // namespace

void ImportedScene::add_cameras()
{
    for (unsigned c = 0; c < from_.mNumCameras; ++c) {
        const aiCamera& from = *from_.mCameras[c];
        const std::string name = from.mName.C_Str();
        const std::optional<double> angle = vertical_angle(from);
        SceneCamera made;
        made.name = name;
        made.node = node_named(from.mName);
        made.camera.eye = vector_of(from.mPosition);
        made.camera.direction = vector_of(from.mLookAt);
        made.camera.up = vector_of(from.mUp);
        const bool sees = has_direction(made.camera.direction) && has_direction(made.camera.up) &&
                          has_direction(glm::cross(made.camera.direction, made.camera.up));
        const bool flat = from.mOrthographicWidth > 0; // half the width
        if (!(flat || angle) || !sees) {
            warn_once(fmt::format("{}: camera '{}' has no view: it is left out", name_, name));
            continue;
        }
        if (flat)
            made.camera.orthographic_height =
                2 * double(from.mOrthographicWidth) / (from.mAspect > 0 ? double(from.mAspect) : 1);
        else
            made.camera.fov_y_rad = *angle;
        builder_.add_camera(std::move(made));
    }
}

/// Programs do not agree about the units of lights, nor about how they fade. So they keep their ratios, do not
/// fade, and the brightest is white.
void ImportedScene::add_lights()
{
    std::vector<Light> lights;
    float brightest = 0;
    for (unsigned l = 0; l < from_.mNumLights; ++l) {
        const aiLight& from = *from_.mLights[l];
        const std::optional<Light::Kind> kind = kind_of(from.mType);
        if (!kind) {
            warn_once(fmt::format("{}: light '{}' is of a kind that is not drawn: it is left out",
                name_, from.mName.C_Str()));
            continue;
        }
        const glm::vec3 color = vector_of(from.mColorDiffuse);
        const float most = std::max({color.r, color.g, color.b});
        if (!(most > 0 && std::isfinite(color.r + color.g + color.b))) continue;
        Light made;
        made.name = from.mName.C_Str();
        made.kind = *kind;
        made.node = node_named(from.mName);
        made.position = vector_of(from.mPosition);
        made.direction = vector_of(from.mDirection);
        if (!has_direction(made.direction)) made.direction = {0, 0, -1};
        made.color = glm::max(color, glm::vec3(0));
        if (*kind == Light::Kind::spot) set_cone(from, made);
        brightest = std::max(brightest, most);
        lights.push_back(std::move(made));
    }
    const float white = materials_.physical() ? std::numbers::pi_v<float> : 1.0f;
    for (Light& light : lights) {
        light.color *= white / brightest;
        builder_.add_light(std::move(light));
    }
}

} // namespace firsthit
