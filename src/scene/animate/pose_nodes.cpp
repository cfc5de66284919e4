// pose_nodes.cpp - where the nodes, joints, lights and the camera of a scene are at a time.
#include "scene/animate/pose_nodes.h"

#include "scene/animate/evaluate_channel.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace firsthit {
namespace {

constexpr std::size_t kNodesPerTask = 32;
constexpr std::size_t kChannelsPerTask = 16;

/// Each channel writes another property of a node, so that they may run side by side.
void apply(const Channel& channel, double time_s, World& world)
{
    std::array<double, 4> value{};
    NodeTransform& transform = world.pose_memory.transform[channel.node];
    switch (channel.path) {
    case Channel::Path::translation:
        evaluate(channel, time_s, value);
        transform.translation = {value[0], value[1], value[2]};
        break;
    case Channel::Path::scale:
        evaluate(channel, time_s, value);
        transform.scale = {value[0], value[1], value[2]};
        break;
    case Channel::Path::rotation:
        evaluate(channel, time_s, value);
        transform.rotation = glm::dquat(value[3], value[0], value[1], value[2]);
        break;
    case Channel::Path::visibility:
        evaluate(channel, time_s, std::span(value).first(1));
        world.node_visible[channel.node] = value[0] != 0;
        break;
    case Channel::Path::weights:
        break; // by pose_weights
    }
}

void apply_channels(const Clip& clip, World& world, Tasks& tasks)
{
    tasks.for_ranges(
        clip.channels.size(), kChannelsPerTask, [&](std::size_t first, std::size_t last) {
            for (std::size_t c = first; c < last; ++c) apply(clip.channels[c], world.time_s, world);
        });
}

/// The matrices of nodes in the world: parents come first.
void place_nodes(const Scene& scene, World& world, Tasks& tasks)
{
    const std::vector<NodeTransform>& transform = world.pose_memory.transform;
    tasks.for_ranges(scene.nodes.size(), kNodesPerTask, [&](std::size_t first, std::size_t last) {
        for (std::size_t n = first; n < last; ++n)
            world.node_matrix[n] =
                scene.nodes[n].transform ? matrix_of(transform[n]) : scene.nodes[n].local;
    });
    for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
        if (scene.nodes[n].parent < 0) continue;
        const auto parent = static_cast<std::size_t>(scene.nodes[n].parent);
        world.node_matrix[n] = world.node_matrix[parent] * world.node_matrix[n];
        world.node_visible[n] &= world.node_visible[parent];
    }
}

/// The weights of all instances that have morph targets: the clip's, else the node's, else the shape's.
void pose_weights(const Scene& scene, const Clip* clip, World& world)
{
    PoseMemory& memory = world.pose_memory;
    memory.first_weight.resize(scene.instances.size());
    memory.target_weight.clear();
    if (scene.shapes.empty()) return;

    memory.weight_channel.assign(scene.nodes.size(), -1);
    if (clip)
        for (std::size_t c = 0; c < clip->channels.size(); ++c)
            if (clip->channels[c].path == Channel::Path::weights)
                memory.weight_channel[clip->channels[c].node] = static_cast<std::int32_t>(c);

    for (std::size_t p = 0; p < scene.instances.size(); ++p) {
        const Instance& instance = scene.instances[p];
        memory.first_weight[p] = memory.target_weight.size();
        if (instance.shape < 0) continue;
        const MeshShape& shape = scene.shapes[static_cast<std::size_t>(instance.shape)];
        const std::size_t targets = shape.targets.size();
        if (targets == 0) continue;
        memory.weight.assign(targets, 0.0);
        const std::int32_t channel = memory.weight_channel[instance.node];
        if (channel >= 0) {
            evaluate(
                clip->channels[static_cast<std::size_t>(channel)], world.time_s, memory.weight);
        } else {
            const std::vector<float>& own = scene.nodes[instance.node].weights;
            const std::vector<float>& rest = own.empty() ? shape.weights : own;
            std::copy_n(rest.begin(), std::min(targets, rest.size()), memory.weight.begin());
        }
        for (const double weight : memory.weight)
            memory.target_weight.push_back(static_cast<float>(weight));
    }
}

/// world_from_object of every joint of every skin, rounded once.
void pose_joints(const Scene& scene, World& world)
{
    PoseMemory& memory = world.pose_memory;
    memory.first_joint.resize(scene.skins.size());
    std::size_t joints = 0;
    for (std::size_t s = 0; s < scene.skins.size(); ++s) {
        memory.first_joint[s] = joints;
        joints += scene.skins[s].joints.size();
    }
    memory.joint_matrix.resize(16 * joints + 16);
    float* to = joint_matrices(memory);
    for (const Skin& skin : scene.skins)
        for (std::size_t j = 0; j < skin.joints.size(); ++j) {
            const glm::dmat4 matrix = world.node_matrix[skin.joints[j]] * skin.inverse_bind[j];
            for (int column = 0; column < 4; ++column)
                for (int row = 0; row < 4; ++row) *to++ = static_cast<float>(matrix[column][row]);
        }
}

glm::dvec3 point_at(const glm::dmat4& matrix, const glm::dvec3& point)
{
    return glm::dmat3(matrix) * point + glm::dvec3(matrix[3]);
}

} // namespace

void pose_nodes(const Scene& scene, const Clip* clip, World& world, Tasks& tasks)
{
    const std::size_t nodes = scene.nodes.size();
    world.node_matrix.resize(nodes);
    world.node_visible.assign(nodes, 1);
    world.pose_memory.transform.resize(nodes);
    for (std::size_t n = 0; n < nodes; ++n)
        if (scene.nodes[n].transform) world.pose_memory.transform[n] = *scene.nodes[n].transform;
    if (clip) apply_channels(*clip, world, tasks);
    place_nodes(scene, world, tasks);
    pose_weights(scene, clip, world);
    pose_joints(scene, world);
}

void pose_lights(const Scene& scene, World& world)
{
    world.lights = scene.lights;
    for (Light& light : world.lights) {
        if (light.node < 0 || light.on_camera) continue;
        const glm::dmat4& matrix = world.node_matrix[static_cast<std::size_t>(light.node)];
        light.position = point_at(matrix, light.position);
        light.direction = glm::dmat3(matrix) * light.direction;
        if (!world.node_visible[static_cast<std::size_t>(light.node)]) light.color = glm::vec3(0);
    }
}

void pose_camera(const Scene& scene, std::int32_t camera, World& world)
{
    if (scene.cameras.empty()) {
        world.camera = framing_camera(world);
        return;
    }
    const SceneCamera& chosen = scene.cameras[static_cast<std::size_t>(camera)];
    world.camera = chosen.camera;
    if (chosen.node < 0) return;
    const glm::dmat4& matrix = world.node_matrix[static_cast<std::size_t>(chosen.node)];
    world.camera.eye = point_at(matrix, chosen.camera.eye);
    world.camera.direction = glm::dmat3(matrix) * chosen.camera.direction;
    world.camera.up = glm::dmat3(matrix) * chosen.camera.up;
}

} // namespace firsthit
