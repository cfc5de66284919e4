// pose.cpp - a scene at a time.
#include "scene/animate/pose.h"

#include "base/tasks.h"
#include "scene/animate/pose_nodes.h"
#include "scene/animate/pose_vertices.h"

#include <firsthit/error.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace firsthit {
namespace {

std::string instance_name(const Scene& scene, std::size_t instance)
{
    const std::string& name = scene.instances[instance].name;
    return "instance " + std::to_string(instance) + (name.empty() ? "" : " '" + name + "'");
}

[[noreturn]] void fail(const Scene& scene, const std::string& message)
{
    throw SceneError(scene.name + ": " + message);
}

void check_index(const Scene& scene, std::int64_t index, std::size_t size, const char* what)
{
    if (index >= static_cast<std::int64_t>(size))
        fail(scene, std::string(what) + " " + std::to_string(index) + " is out of range (" +
                        std::to_string(size) + " exist)");
}

/// Whether morph targets and skin weights are those of so many vertices.
bool fits(const MeshShape& shape, std::size_t vertices)
{
    const auto full = [vertices](const std::vector<glm::vec3>& values) {
        return values.empty() || values.size() == vertices;
    };
    const std::size_t weights = vertices * static_cast<std::size_t>(shape.skin.influences);
    return shape.skin.joint.size() == weights && shape.skin.weight.size() == weights &&
           std::all_of(shape.targets.begin(), shape.targets.end(), [&](const MorphTarget& target) {
               return full(target.position) && full(target.normal) && full(target.tangent);
           });
}

/// What posing relies on. A few nanoseconds an instance.
void check_shape(const Scene& scene)
{
    for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
        if (scene.nodes[n].parent >= static_cast<std::int64_t>(n))
            fail(scene, "node " + std::to_string(n) + " comes before its parent " +
                            std::to_string(scene.nodes[n].parent));
    }
    for (const Light& light : scene.lights)
        check_index(scene, light.node, scene.nodes.size(), "node");
    for (const SceneCamera& camera : scene.cameras)
        check_index(scene, camera.node, scene.nodes.size(), "node");
    for (const Clip& clip : scene.clips)
        for (const Channel& channel : clip.channels)
            check_index(scene, channel.node, scene.nodes.size(), "node");
    for (const Skin& skin : scene.skins)
        for (const std::uint32_t joint : skin.joints)
            check_index(scene, joint, scene.nodes.size(), "node");

    std::size_t next = 0;
    for (std::size_t p = 0; p < scene.instances.size(); ++p) {
        const Instance& instance = scene.instances[p];
        check_index(scene, instance.node, scene.nodes.size(), "node");
        if (instance.first_vertex != next)
            fail(scene, instance_name(scene, p) + " starts at vertex " +
                            std::to_string(instance.first_vertex) + " instead of " +
                            std::to_string(next) +
                            ": instances must follow each other without gaps");
        next += instance.vertex_count;
        for (const MorphKey& key : instance.morph)
            if (key.position.size() != instance.vertex_count ||
                key.normal.size() != instance.vertex_count)
                fail(scene, instance_name(scene, p) + " has a shape without all of its " +
                                std::to_string(instance.vertex_count) + " vertices");
        check_index(scene, instance.shape, scene.shapes.size(), "shape");
        check_index(scene, instance.skin, scene.skins.size(), "skin");
        if (instance.shape >= 0 &&
            !fits(scene.shapes[std::size_t(instance.shape)], instance.vertex_count))
            fail(scene, instance_name(scene, p) +
                            " has morph targets or skin weights without all of its " +
                            std::to_string(instance.vertex_count) + " vertices");
        const bool has_arrays = instance.morph.empty() && !instance.deform;
        if (has_arrays && instance.vertex_count > 0 &&
            (next > scene.position.size() || next > scene.normal.size()))
            fail(scene, instance_name(scene, p) + " lacks positions or normals");
    }
    if (next != scene.vertices)
        fail(scene, "the instances have " + std::to_string(next) + " vertices, the scene " +
                        std::to_string(scene.vertices));
}

void check_settings(const Scene& scene, const PoseSettings& settings)
{
    const auto check = [&](std::int32_t number, std::size_t count, const char* what) {
        if (number < 0 || static_cast<std::size_t>(number) >= std::max<std::size_t>(1, count))
            throw ArgumentError(scene.name + ": there is no " + what + " " +
                                std::to_string(number) + " (" + std::to_string(count) + " exist)");
    };
    if (settings.clip != PoseSettings::kRest) check(settings.clip, scene.clips.size(), "clip");
    check(settings.camera, scene.cameras.size(), "camera");
}

} // namespace

void pose(
    std::shared_ptr<const Scene> shared, const PoseSettings& settings, World& world, Tasks& tasks)
{
    if (!shared) throw ArgumentError("there is no scene to pose");
    if (!std::isfinite(settings.time_s))
        throw ArgumentError("the time of a pose must be a finite number");
    const Scene& scene = *shared;
    check_shape(scene);
    check_settings(scene, settings);
    world.scene = std::move(shared);
    world.time_s = settings.time_s;
    world.clip = settings.clip;
    const Clip* clip = scene.has_clip(settings.clip)
                           ? &scene.clips[static_cast<std::size_t>(settings.clip)]
                           : nullptr;
    pose_nodes(scene, clip, world, tasks);
    const std::size_t bad = pose_vertices(scene, world, tasks);
    if (bad < scene.instances.size())
        fail(scene, instance_name(scene, bad) + " has a coordinate that is not finite at " +
                        std::to_string(world.time_s) + " s");
    pose_lights(scene, world);
    pose_camera(scene, settings.camera, world);
    hang_lights(world.camera, world);
}

void pose(
    std::shared_ptr<const Scene> scene, const PoseSettings& settings, World& world, int threads)
{
    Tasks tasks(threads);
    pose(std::move(scene), settings, world, tasks);
}

void pose(std::shared_ptr<const Scene> scene, double time_s, World& world, int threads)
{
    pose(std::move(scene), PoseSettings{.time_s = time_s}, world, threads);
}

void pose(Scene&& scene, double time_s, World& world, int threads)
{
    pose(std::make_shared<const Scene>(std::move(scene)), time_s, world, threads);
}

} // namespace firsthit
