// pick.cpp - what is under the pointer.
#include "view/frames/pick.h"

#include <glm/geometric.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace firsthit::cli::view {
namespace {

/// A blocker is searched from a point this share of its distance to the eye off the surface.
constexpr double kOffSurface = 1e-4;

std::string light_name(const Light& light, std::size_t number)
{
    const char* kind = light.kind == Light::Kind::point  ? "point"
                       : light.kind == Light::Kind::spot ? "spot"
                                                         : "directional";
    const std::string name = light.name.empty() ? kind : fmt::format("{} '{}'", kind, light.name);
    return fmt::format("light {} ({})", number, name);
}

std::string instance_name(const Scene& scene, std::uint32_t instance)
{
    const std::string& name = scene.instances[instance].name;
    return name.empty() ? fmt::format("instance {}", instance)
                        : fmt::format("instance {} '{}'", instance, name);
}

/// What a ray from a point towards a light meets, by a picture of one pixel.
std::string blocker_of(Renderer& renderer, const World& world, const Light& light,
    const glm::dvec3& point, const glm::dvec3& normal, double lift)
{
    const bool parallel = light.kind == Light::Kind::directional;
    const glm::dvec3 to_light =
        parallel ? -glm::normalize(light.direction) : glm::normalize(light.position - point);
    if (!(glm::dot(to_light, normal) > 0)) return "the surface faces away";
    View view;
    view.width = view.height = 1;
    view.camera.eye = point + (normal + to_light) * lift;
    view.camera.direction = to_light;
    view.camera.up = std::abs(to_light.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    Settings settings;
    settings.color = false;
    settings.shadows = Shadows::none;
    settings.aovs = {Aov::item, Aov::instance, Aov::depth};
    Film film;
    renderer.render(world, view, settings, film);
    const double reach = parallel ? std::numeric_limits<double>::infinity()
                                  : glm::length(light.position - view.camera.eye);
    if (film.item[0] == kNoItem || !(double(film[Aov::depth].value[0]) < reach))
        return light.kind == Light::Kind::spot ? "outside its cone" : "";
    return fmt::format("triangle {} of {} is in the way", film.item[0],
        instance_name(*world.scene, film.instance[0]));
}

} // namespace

Pick pick(
    Renderer& renderer, const World& world, const View& whole, const Settings& given, int x, int y)
{
    Pick found{.x = x, .y = y};
    View view = whole;
    view.region = {x, y, 1, 1};
    Settings settings;
    settings.color = false;
    settings.shadows = given.shadows == Shadows::none ? Shadows::none : Shadows::exact;
    settings.aovs = {Aov::item, Aov::instance, Aov::material, Aov::depth, Aov::barycentric,
        Aov::position, Aov::geometric_normal};
    const bool lights = !world.lights.empty() && world.lights.size() <= kMaxLitLights;
    if (lights) settings.aovs.push_back(Aov::lit);
    Film film;
    renderer.render(world, view, settings, film);
    if (film.item[0] == kNoItem) return found;
    found.hit = true;
    found.triangle = film.item[0];
    found.instance = film.instance[0];
    found.instance_name = instance_name(*world.scene, found.instance);
    const std::uint32_t material = film.material[0];
    found.material_name = fmt::format("material {}", material);
    if (!world.scene->materials[material].name.empty())
        found.material_name += fmt::format(" '{}'", world.scene->materials[material].name);
    const auto vector = [&](Aov aov) {
        const std::vector<float>& v = film[aov].value;
        return glm::vec3(v[0], v[1], v[2]);
    };
    found.t = film[Aov::depth].value[0];
    found.barycentric = {film[Aov::barycentric].value[0], film[Aov::barycentric].value[1]};
    found.position = vector(Aov::position);
    const glm::dvec3 point(found.position), normal(vector(Aov::geometric_normal));
    const double lift = kOffSurface * glm::length(point - whole.camera.eye);
    for (std::size_t k = 0; lights && k < world.lights.size(); ++k) {
        LightAtPoint at{.name = light_name(world.lights[k], k)};
        at.share = film[Aov::lit].value[k];
        if (at.share == 0)
            at.blocker = blocker_of(renderer, world, world.lights[k], point, normal, lift);
        found.lights.push_back(at);
    }
    return found;
}

double seen_t(Renderer& renderer, const World& world, const View& whole, int x, int y)
{
    View view = whole;
    view.region = {x, y, 1, 1};
    Settings settings;
    settings.color = false;
    settings.shadows = Shadows::none;
    settings.aovs = {Aov::depth};
    Film film;
    renderer.render(world, view, settings, film);
    const double t = double(film[Aov::depth].value[0]);
    return std::isfinite(t) ? t : 0;
}

std::vector<std::string> told(const Pick& pick)
{
    std::vector<std::string> lines{fmt::format("pixel {}, {}", pick.x, pick.y)};
    if (!pick.hit) {
        lines.push_back("background");
        return lines;
    }
    lines.push_back(fmt::format("triangle {}", pick.triangle));
    lines.push_back(pick.instance_name);
    lines.push_back(pick.material_name);
    lines.push_back(fmt::format(
        "t {:.6g}  u {:.4f}  v {:.4f}", pick.t, pick.barycentric.x, pick.barycentric.y));
    lines.push_back(fmt::format(
        "at {:.5g}, {:.5g}, {:.5g}", pick.position.x, pick.position.y, pick.position.z));
    for (const LightAtPoint& light : pick.lights) {
        std::string line = fmt::format("{}: {:.0f} %", light.name, 100 * light.share);
        if (!light.blocker.empty()) line += " - " + light.blocker;
        lines.push_back(line);
    }
    return lines;
}

} // namespace firsthit::cli::view
