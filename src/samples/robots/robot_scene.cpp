// robot_scene.cpp - puts shapes, and nodes that walk, into a scene.
#include "samples/robots/robot_scene.h"

#include <utility>

namespace firsthit {

RobotScene::RobotScene(std::string name, double end_s, int frames) : builder_(std::move(name))
{
    clip_.name = "walk";
    clip_.end_s = end_s;
    clip_.frames = frames;
}

std::int32_t RobotScene::add_node(std::string name, std::int32_t parent, const glm::dmat4& local)
{
    Node node;
    node.name = std::move(name);
    node.parent = parent;
    node.local = local;
    return static_cast<std::int32_t>(builder_.add_node(std::move(node)));
}

std::int32_t RobotScene::add_node(std::string name, std::int32_t parent, const Track& track)
{
    Node node;
    node.name = std::move(name);
    node.parent = parent;
    node.transform = transform_at(track, clip_.begin_s);
    const std::uint32_t number = builder_.add_node(std::move(node));
    add_channels(track, number, clip_);
    return static_cast<std::int32_t>(number);
}

void RobotScene::add_shape(
    std::int32_t node, std::uint32_t material, Shape shape, std::vector<glm::vec2> uv)
{
    Mesh mesh;
    mesh.position = std::move(shape.position);
    mesh.normal = std::move(shape.normal);
    mesh.index = std::move(shape.index);
    mesh.uv = std::move(uv);
    builder_.add_instance(
        builder_.add_mesh(std::move(mesh)), static_cast<std::uint32_t>(node), material);
}

Scene RobotScene::build()
{
    builder_.add_clip(std::move(clip_));
    return builder_.build();
}

} // namespace firsthit
