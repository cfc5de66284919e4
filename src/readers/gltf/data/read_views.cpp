// read_views.cpp - the cameras and lights of a glTF document.
#include "readers/gltf/document/loader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace firsthit::gltf {
namespace {

constexpr float kHalfPi = 1.57079632679f;
constexpr float kMaxFov = 3.13f; // below pi

void read_perspective(Loader& loader, const Place& place, Camera& camera)
{
    camera.y_fov_rad = place.number("yfov");
    camera.aspect = place.number("aspectRatio", 0.0f);
    camera.z_near = place.number("znear");
    camera.z_far = place.number("zfar", 0.0f);
    if (!(camera.y_fov_rad > 0.0f))
        place.fail("yfov", fmt::format("{} is not accepted, above 0 is", camera.y_fov_rad));
    if (camera.y_fov_rad > kMaxFov) {
        loader.warn("yfov",
            fmt::format("{}.yfov is {}, {} is used", place.path(), camera.y_fov_rad, kMaxFov));
        camera.y_fov_rad = kMaxFov;
    }
    if (place.has("aspectRatio") && !(camera.aspect > 0.0f)) {
        loader.warn("aspect", fmt::format("{}.aspectRatio is {}; the picture's is used",
                                  place.path(), camera.aspect));
        camera.aspect = 0.0f;
    }
    if (!(camera.z_near > 0.0f))
        place.fail("znear", fmt::format("{} is not accepted, above 0 is", camera.z_near));
    if (place.has("zfar") && camera.z_far <= camera.z_near)
        place.fail("zfar",
            fmt::format("{} is not accepted, above znear ({}) is", camera.z_far, camera.z_near));
}

void read_orthographic(Loader& loader, const Place& place, Camera& camera)
{
    camera.orthographic = true;
    camera.x_mag = place.number("xmag");
    camera.y_mag = place.number("ymag");
    camera.z_near = place.number("znear");
    camera.z_far = place.number("zfar");
    if (camera.x_mag == 0.0f || camera.y_mag == 0.0f) place.fail("", "xmag or ymag is 0");
    if (camera.x_mag < 0.0f || camera.y_mag < 0.0f)
        loader.warn("mag", fmt::format("the sign of {}.xmag or ymag is ignored", place.path()));
    camera.x_mag = std::abs(camera.x_mag);
    camera.y_mag = std::abs(camera.y_mag);
    if (camera.z_near < 0.0f)
        place.fail("znear", fmt::format("{} is not accepted, at least 0 is", camera.z_near));
    if (camera.z_far <= camera.z_near)
        place.fail("zfar",
            fmt::format("{} is not accepted, above znear ({}) is", camera.z_far, camera.z_near));
}

std::optional<LightType> light_type(const std::string& type)
{
    if (type == "directional") return LightType::kDirectional;
    if (type == "point") return LightType::kPoint;
    if (type == "spot") return LightType::kSpot;
    return std::nullopt;
}

void read_cone(Loader& loader, const Place& place, Light& light)
{
    const std::optional<Place> spot = place.find("spot");
    if (!spot) {
        loader.warn(
            "spot", fmt::format("{}.spot is missing; the default cone is used", place.path()));
        return;
    }
    light.inner_cone_rad = spot->number("innerConeAngle", light.inner_cone_rad);
    light.outer_cone_rad = spot->number("outerConeAngle", light.outer_cone_rad);
    const float outer = std::clamp(light.outer_cone_rad, 1e-4f, kHalfPi);
    const float inner = std::clamp(light.inner_cone_rad, 0.0f, outer);
    if (outer != light.outer_cone_rad || inner != light.inner_cone_rad ||
        !(light.inner_cone_rad < light.outer_cone_rad))
        loader.warn(
            "cone", fmt::format("{}: angles from {} to {} are no cone; {} to {} is used",
                        spot->path(), light.inner_cone_rad, light.outer_cone_rad, inner, outer));
    light.inner_cone_rad = inner;
    light.outer_cone_rad = outer;
}

} // namespace

void read_cameras(Loader& loader)
{
    loader.root.each("cameras", [&](std::size_t, const Place& place) {
        Camera camera;
        camera.name = place.text("name");
        const std::string type = place.text("type");
        if (type != "perspective" && type != "orthographic")
            place.fail("type",
                fmt::format("'{}' is not accepted; accepted are perspective, orthographic", type));
        const std::optional<Place> lens = place.find(type.c_str());
        if (!lens) place.fail(type, "is missing");
        if (type == "perspective")
            read_perspective(loader, *lens, camera);
        else
            read_orthographic(loader, *lens, camera);
        loader.document.cameras.push_back(std::move(camera));
    });
}

void read_lights(Loader& loader)
{
    const std::optional<Place> punctual = loader.root.extension("KHR_lights_punctual");
    if (!punctual) return;
    punctual->each("lights", [&](std::size_t, const Place& place) {
        Light light;
        light.name = place.text("name");
        const std::string type_name = place.text("type");
        const std::optional<LightType> type = light_type(type_name);
        light.type = type.value_or(LightType::kPoint);
        std::array<float, 3> color{};
        if (place.numbers("color", color)) light.color = {color[0], color[1], color[2]};
        light.intensity = place.number("intensity", light.intensity);
        light.range = place.number("range", 0.0f);
        if (std::min({light.color.x, light.color.y, light.color.z, light.intensity, light.range}) <
            0.0f) {
            loader.warn(
                "dark light", fmt::format("{} has a negative colour, intensity or range; 0 is used",
                                  place.path()));
            light.color = glm::max(light.color, glm::vec3(0.0f));
            light.intensity = std::max(light.intensity, 0.0f);
            light.range = std::max(light.range, 0.0f);
        }
        if (!type) {
            loader.warn("light type",
                fmt::format("{}.type '{}' is none of directional, point, spot; the light is dark",
                    place.path(), type_name));
            light.intensity = 0.0f;
        }
        if (light.type == LightType::kSpot) read_cone(loader, place, light);
        loader.document.lights.push_back(std::move(light));
    });
}

} // namespace firsthit::gltf
