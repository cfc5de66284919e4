// ground_maker.cpp - puts a floor under the scenes of a run (--ground).
#include "inputs/ground_maker.h"

#include "inputs/scene_source.h"

#include <firsthit/framing.h>
#include <firsthit/render.h>
#include <firsthit/world.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace firsthit::cli {
namespace {

/// Half a side of the floor, in diagonals of the bounding box: its end is far away in the picture.
constexpr double kReach = 40;

/// How far the floor lies below the lowest point, in diagonals, so that flat bottoms are not in its plane.
constexpr double kGap = 1e-5;

/// What a floor that reflects all light looks like where nothing shadows it. (It is rendered.)
///
/// world  whose lights shine on it; they are where the camera takes them
/// view   of the run, whose camera says where the zenith is
glm::vec3 brightness(
    const World& world, const View& view, const Ground& ground, const RenderOptions& options)
{
    Scene floor;
    floor.name = "ground";
    floor.ambient = world.scene->ambient;
    floor.environment = world.scene->environment;
    floor.lights = world.lights;
    for (Light& light : floor.lights) {
        light.on_camera = false;
        light.node = -1;
    }
    Ground white = ground;
    white.color = glm::vec3(1);
    add_ground(floor, white);

    Settings settings;
    const bool studio = wants_studio(options.sky, *world.scene, !options.light.lights.empty());
    apply(options.sky, studio, settings);
    settings.shadows = Shadows::none;
    if (settings.sky.up == glm::dvec3(0)) settings.sky.up = view.camera.up;
    View down;
    down.width = down.height = 1;
    down.camera.eye = ground.middle + ground.up * ground.half_side;
    down.camera.direction = -ground.up;
    down.camera.up = std::abs(ground.up.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    World posed;
    pose(std::move(floor), 0, posed);
    Renderer renderer(1);
    Film film;
    renderer.render(posed, down, settings, film);
    return {film.color.value[0], film.color.value[1], film.color.value[2]};
}

} // namespace

void GroundMaker::add(Scene& scene)
{
    const std::scoped_lock lock(mutex_);
    if (!ground_) {
        const std::shared_ptr<const Scene> borrowed(
            &scene, [](const Scene*) {}); // while find looks at it
        ground_ = find(borrowed);
    }
    add_ground(scene, *ground_);
}

void GroundMaker::look_at_first_frame(const std::function<void(Scene&)>& change)
{
    if (options_.scene.name.find('%') == std::string::npos) return;
    SceneSequence sequence = open_scene(options_.scene, change);
    if (!sequence.is_numbered()) return;
    const double time_s = first_time_s(*sequence.frame(0));
    const std::scoped_lock lock(mutex_);
    ground_ = find(sequence.scene_at(time_s));
}

double GroundMaker::first_time_s(const Scene& scene) const
{
    return frames_of(options_, scene, pose_settings(options_.scene.pose, scene)).time_s.front();
}

Ground GroundMaker::find(const std::shared_ptr<const Scene>& scene)
{
    CameraOptions camera = options_.camera;
    take_size(*scene, camera);
    PoseSettings chosen = pose_settings(options_.scene.pose, *scene);
    chosen.time_s = first_time_s(*scene);
    World world;
    pose(scene, chosen, world);
    const std::string name = options_.scene.shown_name();
    views_.emplace(camera, name);
    const View view = views_->view(world);

    const auto [low, high] = bounds(world);
    const glm::dvec3 middle = 0.5 * (glm::dvec3(low) + glm::dvec3(high));
    const double diagonal =
        std::max(glm::length(glm::dvec3(high) - glm::dvec3(low)), 1e-6 * glm::length(middle));
    Ground ground;
    ground.up = camera.up_axis.value_or(upward_axis(world, usual_up_axis(name)));
    double lowest = 0;
    for (std::size_t v = 0; v < world.position.size(); ++v) {
        const double height = glm::dot(glm::dvec3(world.position[v]) - middle, ground.up);
        lowest = v == 0 ? height : std::min(lowest, height);
    }
    ground.middle = middle + ground.up * (lowest - kGap * diagonal);
    ground.half_side = std::max(kReach * diagonal, 1e-6);
    if (options_.ground.color) {
        ground.color = *options_.ground.color;
        return ground;
    }
    const glm::vec3 lit = brightness(world, view, ground, options_);
    for (int c = 0; c < 3; ++c)
        ground.color[c] = lit[c] > 0 ? scene->background[c] / lit[c] : scene->background[c];
    return ground;
}

} // namespace firsthit::cli
