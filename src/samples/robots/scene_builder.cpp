// scene_builder.cpp - puts nodes, tracks and shapes together to a scene.
#include "samples/robots/scene_builder.h"

#include <utility>

namespace firsthit {

std::uint32_t SceneBuilder::add_material(Material material)
{
    scene_.materials.push_back(std::move(material));
    return static_cast<std::uint32_t>(scene_.materials.size() - 1);
}

std::int32_t SceneBuilder::add_track(Track track)
{
    scene_.tracks.push_back(std::move(track));
    return static_cast<std::int32_t>(scene_.tracks.size() - 1);
}

std::int32_t SceneBuilder::add_node(std::string name, std::int32_t parent, const glm::dmat4& local)
{
    Node& node = scene_.nodes.emplace_back();
    node.name = std::move(name);
    node.parent = parent;
    node.local = local;
    return static_cast<std::int32_t>(scene_.nodes.size() - 1);
}

std::int32_t SceneBuilder::add_node(std::string name, std::int32_t parent, Track track)
{
    const std::int32_t node = add_node(std::move(name), parent, glm::dmat4(1));
    scene_.nodes.back().track = add_track(std::move(track));
    return node;
}

void SceneBuilder::add_part(
    std::int32_t node, std::uint32_t material, Shape shape, std::vector<glm::vec2> uv)
{
    const auto first_vertex = static_cast<std::uint32_t>(scene_.vertices);
    Part& part = scene_.parts.emplace_back();
    part.name = scene_.nodes[static_cast<std::size_t>(node)].name;
    part.node = static_cast<std::uint32_t>(node);
    part.material = material;
    part.first_vertex = first_vertex;
    part.vertex_count = static_cast<std::uint32_t>(shape.position.size());
    part.first_triangle = static_cast<std::uint32_t>(scene_.index.size());
    part.triangle_count = static_cast<std::uint32_t>(shape.index.size());

    scene_.position.insert(scene_.position.end(), shape.position.begin(), shape.position.end());
    scene_.normal.insert(scene_.normal.end(), shape.normal.begin(), shape.normal.end());
    uv.resize(shape.position.size(), glm::vec2(0));
    scene_.uv.insert(scene_.uv.end(), uv.begin(), uv.end());
    for (const glm::uvec3& corners : shape.index) scene_.index.push_back(corners + first_vertex);
    scene_.owner.resize(scene_.index.size(), static_cast<std::uint32_t>(scene_.parts.size() - 1));
    scene_.vertices = scene_.position.size();
}

} // namespace firsthit
