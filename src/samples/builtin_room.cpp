// builtin_room.cpp - a furnished room with seven lights, through which a toy car drives.
#include "samples/builtin.h"
#include "samples/room/furniture.h"

#include <glm/geometric.hpp>

namespace firsthit {
namespace {

/// From 0 to 1 over the clip, slow at both ends.
double eased(double time_s)
{
    const double u = time_s / kRoomEnd;
    return u * u * (3 - 2 * u);
}

/// From the corner by the sideboard past the table to the armchair; always inside.
NodeTransform camera_at(double time_s)
{
    const double u = eased(time_s), bow = 4 * u * (1 - u);
    const glm::dvec3 eye(2.35 - 3.4 * u, 1.52 - 0.25 * bow, 2.05 + 0.15 * bow);
    const glm::dvec3 target(-0.95 + 2.1 * u, 0.92 - 0.12 * bow, -1.05 - 0.25 * u);
    NodeTransform camera;
    camera.translation = eye;
    const glm::dvec3 back = glm::normalize(eye - target);
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), back));
    camera.rotation = glm::quat_cast(glm::dmat3(right, glm::cross(back, right), back));
    return camera;
}

} // namespace

Scene make_room()
{
    RoomScene room;
    add_walls(room);
    add_window(room);
    add_rug(room);
    add_table(room);
    add_chairs(room);
    add_crockery(room);
    add_baskets(room);
    add_shelf(room);
    add_sideboard(room);
    add_armchair(room);
    add_plant(room);
    add_wall_things(room);
    add_lamps(room);
    add_toys(room);
    add_car(room);

    SceneBuilder& builder = room.builder();
    builder.add_light({.kind = Light::Kind::directional,
        .direction = {0.85, -0.43, 0.20},
        .color = {2.3f, 1.85f, 1.28f},
        .name = "sun"});
    const std::int32_t way = room.add_moving_node("camera", -1, 0.5, camera_at);
    builder.add_camera(
        {.name = "camera", .camera = {.eye = {0, 0, 0}, .fov_y_rad = 0.92}, .node = way});
    builder.set_background({0.42f, 0.62f, 0.86f});
    return room.build();
}

} // namespace firsthit
