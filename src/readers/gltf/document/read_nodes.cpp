// read_nodes.cpp - the nodes, skins and scenes of a glTF document, and whether the nodes are trees.
#include "readers/gltf/document/check_attributes.h"
#include "readers/gltf/document/loader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

namespace firsthit::gltf {
namespace {

constexpr int kMaxDepth = 1024; // of a tree, so that it can be walked recursively

void read_transform(Loader& loader, const Place& place, Node& node)
{
    std::array<float, 16> m{};
    if (place.numbers("matrix", m)) {
        glm::mat4& matrix = node.matrix.emplace(1.0f);
        for (int k = 0; k < 16; ++k) matrix[k / 4][k % 4] = m[std::size_t(k)];
        if (place.has("translation") || place.has("rotation") || place.has("scale"))
            loader.warn("matrix and TRS",
                fmt::format(
                    "{} has a matrix and translation, rotation or scale; the matrix is used",
                    place.path()));
        if (m[3] != 0.0f || m[7] != 0.0f || m[11] != 0.0f || m[15] != 1.0f) {
            loader.warn("matrix",
                fmt::format("the last row of {}.matrix is taken as 0, 0, 0, 1", place.path()));
            for (int k = 0; k < 4; ++k) matrix[k][3] = k == 3 ? 1.0f : 0.0f;
        }
    }
    std::array<float, 3> v{};
    if (place.numbers("translation", v)) node.translation = {v[0], v[1], v[2]};
    if (place.numbers("scale", v)) node.scale = {v[0], v[1], v[2]};
    std::array<float, 4> q{};
    if (place.numbers("rotation", q)) {
        node.rotation = glm::quat(q[3], q[0], q[1], q[2]);
        const float length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        if (!(std::abs(length - 1.0f) < 1e-2f))
            loader.warn("rotation",
                fmt::format("{}.rotation has length {} instead of 1", place.path(), length));
    }
}

void read_instancing(Loader& loader, const Place& place, Node& node)
{
    const std::optional<Place> found = place.extension("EXT_mesh_gpu_instancing");
    if (!found) return;
    const std::optional<Place> attributes = found->find("attributes");
    if (!attributes) found->fail("attributes", "is missing");
    if (node.mesh == kNone) {
        loader.warn("instancing", fmt::format("{} has instances, but no mesh", place.path()));
        return;
    }
    attributes->each_index(
        loader.document.accessors.size(), [&](const std::string& name, int accessor) {
            using enum ElementType;
            if (name == "ROTATION")
                check_type(loader, *attributes, name, accessor, {kVec4});
            else if (name == "TRANSLATION" || name == "SCALE")
                check_type(loader, *attributes, name, accessor, {kVec3});
            else
                return;
            node.instancing[name] = accessor;
        });
    const auto count = [&](int accessor) {
        return loader.document.accessors[std::size_t(accessor)].count;
    };
    for (const auto& [name, accessor] : node.instancing)
        if (count(accessor) != count(node.instancing.begin()->second))
            attributes->fail(name,
                fmt::format("accessor {} has {} elements, {} has {}", accessor, count(accessor),
                    node.instancing.begin()->first, count(node.instancing.begin()->second)));
}

void read_mesh_of(Loader& loader, const Place& place, Node& node)
{
    Document& document = loader.document;
    node.mesh = place.index("mesh", document.meshes.size());
    node.skin = place.index("skin", loader.root.length("skins"));
    if (node.skin != kNone && node.mesh == kNone) {
        loader.warn("skin", fmt::format("{} has a skin, but no mesh", place.path()));
        node.skin = kNone;
    }
    node.weights = place.numbers("weights");
    if (node.mesh == kNone) {
        if (!node.weights.empty())
            loader.warn("node weights", fmt::format("{} has weights, but no mesh", place.path()));
        node.weights.clear();
        return;
    }
    const Mesh& mesh = document.meshes[std::size_t(node.mesh)];
    const auto is_skinned = [](const Primitive& p) { return p.attributes.contains("JOINTS_0"); };
    if (node.skin != kNone &&
        std::none_of(mesh.primitives.begin(), mesh.primitives.end(), is_skinned))
        loader.warn(
            "joints", fmt::format("{} has a skin, but its mesh has no JOINTS_0", place.path()));
    const std::size_t targets = mesh.primitives.empty() ? 0 : mesh.primitives[0].targets.size();
    if (!node.weights.empty() && node.weights.size() != targets) {
        loader.warn("weights", fmt::format("{} has {} weights for {} morph targets", place.path(),
                                   node.weights.size(), targets));
        node.weights.resize(targets);
    }
}

void set_parents(Loader& loader)
{
    std::vector<Node>& nodes = loader.document.nodes;
    loader.root.each("nodes", [&](std::size_t number, const Place& place) {
        for (const int child : nodes[number].children) {
            int& parent = nodes[std::size_t(child)].parent;
            if (parent != kNone)
                place.fail("children",
                    fmt::format("node {} is already a child of node {}; accepted is one parent",
                        child, parent));
            parent = static_cast<int>(number);
        }
    });
}

/// With one parent each, what cannot be reached from a root is on a cycle or below one.
void check_trees(const Loader& loader)
{
    const std::vector<Node>& nodes = loader.document.nodes;
    std::vector<std::pair<int, int>> open; // node, depth
    for (std::size_t k = 0; k < nodes.size(); ++k)
        if (nodes[k].parent == kNone) open.emplace_back(static_cast<int>(k), 1);
    std::vector<bool> reached(nodes.size());
    while (!open.empty()) {
        const auto [node, depth] = open.back();
        open.pop_back();
        reached[std::size_t(node)] = true;
        if (depth > kMaxDepth)
            loader.root.fail(fmt::format("nodes[{}]", node),
                fmt::format("is more than {} nodes below its root", kMaxDepth));
        for (const int child : nodes[std::size_t(node)].children)
            open.emplace_back(child, depth + 1);
    }
    const auto lost = std::find(reached.begin(), reached.end(), false);
    if (lost != reached.end())
        loader.root.fail(fmt::format("nodes[{}]", lost - reached.begin()),
            "is on a cycle of nodes, or below one");
}

/// The root of each node.
std::vector<int> find_roots(const Document& document)
{
    std::vector<int> root(document.nodes.size(), kNone);
    std::vector<int> path;
    for (std::size_t k = 0; k < root.size(); ++k) {
        int node = static_cast<int>(k);
        const auto parent = [&] { return document.nodes[std::size_t(node)].parent; };
        path.clear();
        for (; root[std::size_t(node)] == kNone && parent() != kNone; node = parent())
            path.push_back(node);
        if (root[std::size_t(node)] == kNone) root[std::size_t(node)] = node;
        for (const int below : path) root[std::size_t(below)] = root[std::size_t(node)];
    }
    return root;
}

} // namespace

void read_nodes(Loader& loader)
{
    Document& document = loader.document;
    const std::size_t count = loader.root.length("nodes");
    loader.root.each("nodes", [&](std::size_t, const Place& place) {
        Node node;
        node.name = place.text("name");
        node.children = place.indices("children", count);
        read_transform(loader, place, node);
        read_mesh_of(loader, place, node);
        node.camera = place.index("camera", document.cameras.size());
        if (const auto light = place.extension("KHR_lights_punctual"))
            node.light = light->index("light", document.lights.size());
        read_instancing(loader, place, node);
        document.nodes.push_back(std::move(node));
    });
    set_parents(loader);
    check_trees(loader);
}

void read_skins(Loader& loader)
{
    Document& document = loader.document;
    const std::vector<int> roots = find_roots(document);
    loader.root.each("skins", [&](std::size_t, const Place& place) {
        Skin skin;
        skin.name = place.text("name");
        skin.joints = place.indices("joints", document.nodes.size());
        if (skin.joints.empty()) place.fail("joints", "is missing or empty");
        std::vector<int> sorted = skin.joints;
        std::sort(sorted.begin(), sorted.end());
        if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
            loader.warn("joints twice", fmt::format("{} names a joint twice", place.path()));
        const auto has_other_root = [&](int joint) {
            return roots[std::size_t(joint)] != roots[std::size_t(sorted.front())];
        };
        if (std::any_of(sorted.begin(), sorted.end(), has_other_root))
            loader.warn(
                "common root", fmt::format("the joints of {} have no common root", place.path()));
        skin.skeleton = place.index("skeleton", document.nodes.size());
        skin.inverse_bind_matrices = place.index("inverseBindMatrices", document.accessors.size());
        if (skin.inverse_bind_matrices != kNone) {
            check_type(loader, place, "inverseBindMatrices", skin.inverse_bind_matrices,
                {ElementType::kMat4});
            const Accessor& accessor = document.accessors[std::size_t(skin.inverse_bind_matrices)];
            if (accessor.component != ComponentType::kFloat)
                place.fail("inverseBindMatrices",
                    fmt::format("componentType {} is not accepted; accepted is 5126",
                        static_cast<int>(accessor.component)));
            if (accessor.count < skin.joints.size())
                place.fail("inverseBindMatrices",
                    fmt::format("{} matrices for {} joints", accessor.count, skin.joints.size()));
        }
        document.skins.push_back(std::move(skin));
    });
}

void read_scenes(Loader& loader)
{
    Document& document = loader.document;
    loader.root.each("scenes", [&](std::size_t, const Place& place) {
        SceneRoots scene;
        scene.name = place.text("name");
        scene.nodes = place.indices("nodes", document.nodes.size());
        if (scene.nodes.empty())
            loader.warn("empty scene", fmt::format("{} has no nodes", place.path()));
        std::vector<int> sorted = scene.nodes;
        std::sort(sorted.begin(), sorted.end());
        if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
            twice != sorted.end())
            place.fail("nodes", fmt::format("node {} is named twice", *twice));
        for (const int node : scene.nodes)
            if (const int parent = document.nodes[std::size_t(node)].parent; parent != kNone)
                place.fail("nodes",
                    fmt::format("node {} is a child of node {}; accepted are roots", node, parent));
        document.scenes.push_back(std::move(scene));
    });
    document.scene = loader.root.index("scene", document.scenes.size());
}

} // namespace firsthit::gltf
