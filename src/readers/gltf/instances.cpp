// instances.cpp - the meshes of a glTF document, where nodes place them.
#include "readers/gltf/scene_maker.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace firsthit::gltf {
namespace {

/// What EXT_mesh_gpu_instancing says of one instance.
struct Instancing {
    std::vector<float> translation, rotation, scale;
    std::size_t count = 0;

    Instancing(const Document& document, const Node& node)
    {
        const auto read = [&](const char* name, int components, std::vector<float>& values) {
            const auto found = node.instancing.find(name);
            if (found == node.instancing.end()) return;
            values = read_floats(document, found->second, components);
            count = values.size() / static_cast<std::size_t>(components);
        };
        read("TRANSLATION", 3, translation);
        read("ROTATION", 4, rotation);
        read("SCALE", 3, scale);
    }

    NodeTransform transform(std::size_t k) const
    {
        NodeTransform made;
        if (!translation.empty())
            made.translation = {translation[3 * k], translation[3 * k + 1], translation[3 * k + 2]};
        if (!scale.empty()) made.scale = {scale[3 * k], scale[3 * k + 1], scale[3 * k + 2]};
        if (!rotation.empty()) {
            const float* q = &rotation[4 * k];
            const glm::dquat turn(q[3], q[0], q[1], q[2]);
            const double length = std::sqrt(glm::dot(turn, turn));
            if (length > 0) made.rotation = turn * (1 / length);
        }
        return made;
    }
};

} // namespace

void SceneMaker::add_instances(int number)
{
    const auto n = static_cast<std::size_t>(number);
    const Node& node = document_.nodes[n];
    const auto own = static_cast<std::uint32_t>(scene_node_[n]);
    if (node.instancing.empty()) {
        add_primitives(number, own);
        return;
    }
    if (node.skin != kNone) {
        warn_once(fmt::format("{}: node '{}' has instances of a skinned mesh: they are drawn once",
            document_.name, node.name));
        add_primitives(number, own);
        return;
    }
    const Instancing instances(document_, node);
    instanced_nodes_ += instances.count;
    if (instanced_nodes_ > kMostInstancedNodes)
        throw SceneError(fmt::format("{}: node '{}': more than {} instances", document_.name,
            node.name, kMostInstancedNodes));
    for (std::size_t k = 0; k < instances.count; ++k) {
        firsthit::Node made;
        made.name = fmt::format("{}[{}]", node.name, k);
        made.parent = static_cast<std::int32_t>(own);
        made.transform = instances.transform(k);
        made.weights = node.weights;
        add_primitives(number, builder_.add_node(std::move(made)));
    }
}

void SceneMaker::add_primitives(int number, std::uint32_t scene_node)
{
    const Node& node = document_.nodes[static_cast<std::size_t>(number)];
    const Mesh& mesh = document_.meshes[static_cast<std::size_t>(node.mesh)];
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
        const Primitive& primitive = mesh.primitives[p];
        const bool skinned = node.skin != kNone && primitive.attributes.contains("JOINTS_0");
        const int skin = skinned ? node.skin : kNone;
        const std::int32_t made = mesh_of(node.mesh, static_cast<int>(p), skin);
        if (made < 0) continue;
        const auto m = static_cast<std::size_t>(made);
        if (size_[m] > room_)
            throw SceneError(
                fmt::format("{}: node '{}': instances repeat more than {} vertices or triangles",
                    document_.name, node.name, kMostRepeated));
        room_ -= size_[m];
        const std::string& name = node.name.empty() ? mesh.name : node.name;
        builder_.add_instance(static_cast<std::uint32_t>(made), scene_node,
            material_of(primitive.material), skin,
            mesh.primitives.size() > 1 ? fmt::format("{} #{}", name, p) : name);
    }
}

/// The scene's mesh of a primitive under a skin, or -1 where it has no triangles to show.
std::int32_t SceneMaker::mesh_of(int mesh, int primitive, int skin)
{
    const auto [entry, is_new] = mesh_.try_emplace({mesh, primitive, skin}, -1);
    if (!is_new) return entry->second;
    const Mesh& from = document_.meshes[static_cast<std::size_t>(mesh)];
    const Primitive& triangles = from.primitives[static_cast<std::size_t>(primitive)];
    if (triangles.mode < PrimitiveMode::kTriangles) {
        warn_once(fmt::format(
            "{}: mesh '{}': points and lines are not drawn", document_.name, from.name));
        return -1;
    }
    if (!triangles.attributes.contains("POSITION")) {
        warn_once(fmt::format("{}: mesh '{}': a primitive without positions is not drawn",
            document_.name, from.name));
        return -1;
    }
    const std::size_t joints =
        skin == kNone ? 0 : document_.skins[static_cast<std::size_t>(skin)].joints.size();
    bool identity_joint = false;
    firsthit::Mesh made;
    try {
        made = read_primitive(document_, from, triangles, joints, identity_joint);
    } catch (const FileError& error) {
        // The rest is shown. Where nothing is left it is an error, unless the document itself says
        // that its bytes are elsewhere.
        warn_once(fmt::format("{}; it is not drawn", error.what()));
        const bool is_elsewhere = std::any_of(document_.buffers.begin(), document_.buffers.end(),
            [](const Buffer& buffer) { return buffer.missing == kNoUri; });
        if (!unread_ && !is_elsewhere) unread_.emplace(error.what());
        return -1;
    }
    add_tangents(triangles, made);
    if (identity_joint) needs_identity_[static_cast<std::size_t>(skin)] = 1;
    // Without normals every corner becomes a vertex.
    size_.push_back(made.normal.empty() ? 3 * made.index.size()
                                        : std::max(made.position.size(), made.index.size()));
    return entry->second = static_cast<std::int32_t>(builder_.add_mesh(std::move(made)));
}

} // namespace firsthit::gltf
