// scene_maker.cpp - the nodes of a glTF document, and the lights and cameras that hang on them.
#include "readers/gltf/scene_maker.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <utility>

namespace firsthit::gltf {
namespace {

/// At rest; a rotation of length 0 counts as none.
NodeTransform transform_of(const Node& node)
{
    NodeTransform transform;
    transform.translation = node.translation;
    transform.scale = node.scale;
    const glm::dquat q(node.rotation.w, node.rotation.x, node.rotation.y, node.rotation.z);
    const double length = std::sqrt(glm::dot(q, q));
    if (length > 0) transform.rotation = q * (1 / length);
    return transform;
}

} // namespace

SceneMaker::SceneMaker(const Document& document, int scene)
    : document_(document),
      builder_(std::filesystem::path(document.name).filename().string()),
      scene_node_(document.nodes.size(), -1),
      needs_identity_(document.skins.size(), 0),
      material_(document.materials.size() + 1, -1),
      room_(kMostRepeated)
{
    for (const Accessor& accessor : document.accessors) room_ += accessor.count;
    if (scene != kNone) {
        roots_ = document.scenes[static_cast<std::size_t>(scene)].nodes;
    } else {
        for (std::size_t n = 0; n < document.nodes.size(); ++n)
            if (document.nodes[n].parent == kNone) roots_.push_back(static_cast<int>(n));
    }
}

Scene SceneMaker::make()
{
    for (const int root : roots_) add_tree(root, true);
    // Joints and channels may name nodes of trees that the scene does not show.
    for (std::size_t n = 0; n < document_.nodes.size(); ++n)
        if (document_.nodes[n].parent == kNone && scene_node_[n] < 0)
            add_tree(static_cast<int>(n), false);
    if (size_.empty() && unread_) throw FileError(*unread_);
    if (size_.empty()) warn_once(fmt::format("{}: there are no triangles to show", document_.name));
    add_skins();
    add_clips();
    for (const std::string& warning : document_.warnings) builder_.warn(warning);
    builder_.set_extensions(document_.extensions_used);
    for (const std::string& file : document_.files) builder_.add_file(file);
    return builder_.build();
}

/// Adds a node and all below it, depth first, a node before its children, without recursion.
void SceneMaker::add_tree(int root, bool visible)
{
    std::vector<int> open{root};
    while (!open.empty()) {
        const int node = open.back();
        open.pop_back();
        add_node(node, visible);
        const std::vector<int>& children = document_.nodes[static_cast<std::size_t>(node)].children;
        open.insert(open.end(), children.rbegin(), children.rend());
    }
}

void SceneMaker::add_node(int number, bool visible)
{
    const auto n = static_cast<std::size_t>(number);
    const Node& node = document_.nodes[n];
    firsthit::Node made;
    made.name = node.name;
    if (node.parent != kNone) made.parent = scene_node_[static_cast<std::size_t>(node.parent)];
    if (node.matrix)
        made.local = glm::dmat4(*node.matrix);
    else
        made.transform = transform_of(node);
    made.weights = node.weights;
    scene_node_[n] = static_cast<std::int32_t>(builder_.add_node(std::move(made)));
    if (!visible) return;
    if (node.mesh != kNone) add_instances(number);
    if (node.light != kNone) add_light(number);
    if (node.camera != kNone) add_camera(number);
}

void SceneMaker::add_light(int number)
{
    const auto n = static_cast<std::size_t>(number);
    const Light& light = document_.lights[static_cast<std::size_t>(document_.nodes[n].light)];
    firsthit::Light made;
    made.name = light.name.empty() ? document_.nodes[n].name : light.name;
    made.kind = light.type == LightType::kDirectional ? firsthit::Light::Kind::directional
                : light.type == LightType::kSpot      ? firsthit::Light::Kind::spot
                                                      : firsthit::Light::Kind::point;
    made.direction = {0, 0, -1};
    made.inner_rad = light.inner_cone_rad;
    made.outer_rad = light.outer_cone_rad;
    made.color = light.intensity * light.color;
    made.inverse_square = light.type != LightType::kDirectional;
    made.range = light.range;
    made.node = scene_node_[n];
    builder_.add_light(std::move(made));
}

void SceneMaker::add_camera(int number)
{
    const auto n = static_cast<std::size_t>(number);
    const Camera& camera = document_.cameras[static_cast<std::size_t>(document_.nodes[n].camera)];
    const std::string name = camera.name.empty() ? document_.nodes[n].name : camera.name;
    SceneCamera made;
    made.name = name;
    made.camera.eye = {0, 0, 0};
    if (camera.orthographic)
        made.camera.orthographic_height = 2 * std::abs(double(camera.y_mag));
    else
        made.camera.fov_y_rad = camera.y_fov_rad;
    made.node = scene_node_[n];
    builder_.add_camera(std::move(made));
}

void SceneMaker::warn_once(const std::string& warning)
{
    if (warned_.insert(warning).second) builder_.warn(warning);
}

} // namespace firsthit::gltf
