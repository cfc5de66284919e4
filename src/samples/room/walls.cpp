// walls.cpp - floor, walls, ceiling, beams, skirting boards and the door.
#include "samples/room/furniture.h"
#include "samples/room/swept.h"
#include "samples/room/window_place.h"

#include <utility>

namespace firsthit {
namespace {

constexpr double kThick = 0.10; // half of a wall's thickness, m

/// A box between two corners.
void add_between(Shape& shape, const glm::dvec3& low, const glm::dvec3& high)
{
    const glm::dvec3 middle = 0.5 * (low + high);
    add_box(shape, 0.5 * (high - low), moved(middle.x, middle.y, middle.z));
}

void add_plaster(RoomScene& room, std::int32_t node)
{
    const RoomMaterials& m = room.materials();
    const double x = kRoomHalf.x, z = kRoomHalf.z, top = 2 * kRoomHalf.y, t = 2 * kThick;
    Shape wall;
    add_between(wall, {x, 0, -z - t}, {x + t, top, z + t});
    add_between(wall, {-x - t, 0, z}, {x, top, z + t});
    // Around the window.
    const WindowPlace w = window_place();
    add_between(wall, {-x - t, 0, -z - t}, {-x, top, w.low_z});
    add_between(wall, {-x - t, 0, w.high_z}, {-x, top, z});
    add_between(wall, {-x - t, 0, w.low_z}, {-x, w.sill, w.high_z});
    add_between(wall, {-x - t, w.head, w.low_z}, {-x, top, w.high_z});
    std::vector<glm::vec2> uv = box_mapping(wall, 2.0);
    room.add(node, m.wall, std::move(wall), std::move(uv));

    Shape accent;
    add_between(accent, {-x, 0, -z - t}, {x, top, -z});
    uv = box_mapping(accent, 2.0);
    room.add(node, m.accent_wall, std::move(accent), std::move(uv));

    Shape floor;
    add_between(floor, {-x - t, -t, -z - t}, {x + t, 0, z + t});
    uv = box_mapping(floor, 2.4);
    room.add(node, m.floor, std::move(floor), std::move(uv));

    Shape ceiling;
    add_between(ceiling, {-x - t, top, -z - t}, {x + t, top + t, z + t});
    room.add(node, m.ceiling, std::move(ceiling));
}

void add_beams(RoomScene& room, std::int32_t node)
{
    Shape beams;
    for (const double x : {-2.1, -0.7, 0.7, 2.1})
        add_rounded_box(beams, {0.07, 0.08, kRoomHalf.z - 0.001}, 0.012, 2,
            moved(x, 2 * kRoomHalf.y - 0.081, 0));
    std::vector<glm::vec2> uv = box_mapping(beams, 1.0, true);
    room.add(node, room.materials().walnut, std::move(beams), std::move(uv));
}

void add_skirting(RoomScene& room, std::int32_t node)
{
    Shape boards;
    const double x = kRoomHalf.x, z = kRoomHalf.z;
    for (const double side : {-1.0, 1.0}) {
        add_rounded_box(
            boards, {x - 0.002, 0.055, 0.009}, 0.006, 2, moved(0, 0.056, side * (z - 0.01)));
        add_rounded_box(
            boards, {0.009, 0.055, z - 0.022}, 0.006, 2, moved(side * (x - 0.01), 0.056, 0));
    }
    room.add(node, room.materials().white, std::move(boards));
}

void add_door(RoomScene& room, std::int32_t node)
{
    const double z = kRoomHalf.z - 0.03;
    Shape door;
    add_rounded_box(door, {0.44, 1.02, 0.02}, 0.008, 2, moved(-1.2, 1.03, z));
    for (const double y : {0.45, 1.15, 1.72})
        for (const double side : {-1.0, 1.0})
            add_rounded_box(door, {0.15, y > 1 && y < 1.5 ? 0.30 : 0.20, 0.012}, 0.010, 2,
                moved(-1.2 + side * 0.20, y, z - 0.018));
    for (const double side : {-1.0, 1.0})
        add_rounded_box(door, {0.05, 1.06, 0.028}, 0.01, 2, moved(-1.2 + side * 0.50, 1.065, z));
    add_rounded_box(door, {0.58, 0.05, 0.028}, 0.01, 2, moved(-1.2, 2.18, z));
    room.add(node, room.materials().white, std::move(door));

    Shape handle;
    add_rod(handle, {-0.85, 1.02, z - 0.02}, {-0.85, 1.02, z - 0.075}, 0.011, 12);
    add_rod(handle, {-0.84, 1.02, z - 0.07}, {-0.97, 1.02, z - 0.07}, 0.010, 12);
    room.add(node, room.materials().brass, std::move(handle));
}

} // namespace

void add_walls(RoomScene& room)
{
    const std::int32_t node = room.add_node("walls", -1, glm::dmat4(1));
    add_plaster(room, node);
    const std::int32_t wood = room.add_node("beams, boards, door", -1, glm::dmat4(1));
    add_beams(room, wood);
    add_skirting(room, wood);
    add_door(room, wood);
}

} // namespace firsthit
