// room_scene.cpp - puts the room's things together.
#include "samples/room/room_scene.h"

#include "samples/trigonometry.h"

#include <cstddef>
#include <utility>

namespace firsthit {
namespace {

/// One key's place and turn.
using RoomKey = std::vector<double>;

/// A cubic channel through values at equal steps.
Channel cubic_channel(
    std::uint32_t node, Channel::Path path, double step_s, const std::vector<RoomKey>& keys)
{
    Channel channel;
    channel.node = node;
    channel.path = path;
    channel.interpolation = Channel::Interpolation::cubic;
    const std::size_t count = keys.size();
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t before = k > 0 ? k - 1 : k, after = k + 1 < count ? k + 1 : k;
        RoomKey slope;
        for (std::size_t c = 0; c < keys[k].size(); ++c)
            slope.push_back((keys[after][c] - keys[before][c]) /
                            (static_cast<double>(after - before) * step_s));
        channel.time_s.push_back(static_cast<double>(k) * step_s);
        for (const RoomKey* part : {&std::as_const(slope), &keys[k], &std::as_const(slope)})
            channel.value.insert(channel.value.end(), part->begin(), part->end());
    }
    return channel;
}

} // namespace

RoomScene::RoomScene() : builder_("room"), materials_(add_room_materials(builder_))
{
    clip_.name = "drive";
    clip_.end_s = kRoomEnd;
    clip_.frames = 601; // 30 a second
}

std::int32_t RoomScene::add_node(std::string name, std::int32_t parent, const glm::dmat4& local)
{
    Node node;
    node.name = std::move(name);
    node.parent = parent;
    node.local = local;
    return static_cast<std::int32_t>(builder_.add_node(std::move(node)));
}

std::int32_t RoomScene::add_moving_node(std::string name, std::int32_t parent, double step_s,
    const std::function<NodeTransform(double time_s)>& movement)
{
    Node node;
    node.name = std::move(name);
    node.parent = parent;
    node.transform = movement(0);
    const std::uint32_t number = builder_.add_node(std::move(node));

    const int steps = static_cast<int>(kRoomEnd / step_s + 0.5);
    std::vector<RoomKey> places, turns;
    glm::dquat last = movement(0).rotation;
    for (int k = 0; k <= steps; ++k) {
        const NodeTransform at = movement(k * step_s);
        places.push_back({at.translation.x, at.translation.y, at.translation.z});
        // Of the two quaternions of a turn, the one nearer to the last key's.
        last = glm::dot(last, at.rotation) < 0 ? -at.rotation : at.rotation;
        turns.push_back({last.x, last.y, last.z, last.w});
    }
    clip_.channels.push_back(cubic_channel(number, Channel::Path::translation, step_s, places));
    clip_.channels.push_back(cubic_channel(number, Channel::Path::rotation, step_s, turns));
    return static_cast<std::int32_t>(number);
}

std::uint32_t RoomScene::add_mesh(Shape shape, std::vector<glm::vec2> uv)
{
    Mesh mesh;
    mesh.position = std::move(shape.position);
    mesh.normal = std::move(shape.normal);
    mesh.index = std::move(shape.index);
    mesh.uv = std::move(uv);
    return builder_.add_mesh(std::move(mesh));
}

void RoomScene::place(std::uint32_t mesh, std::int32_t node, std::uint32_t material)
{
    builder_.add_instance(mesh, static_cast<std::uint32_t>(node), material);
}

void RoomScene::add(
    std::int32_t node, std::uint32_t material, Shape shape, std::vector<glm::vec2> uv)
{
    place(add_mesh(std::move(shape), std::move(uv)), node, material);
}

Scene RoomScene::build()
{
    builder_.add_clip(std::move(clip_));
    return builder_.build();
}

glm::dquat turn_about(const glm::dvec3& axis, double angle_rad)
{
    const auto [s, c] = sine_cosine(angle_rad / 2);
    return glm::dquat(c, s * axis.x, s * axis.y, s * axis.z);
}

} // namespace firsthit
