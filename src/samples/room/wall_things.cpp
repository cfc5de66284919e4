// wall_things.cpp - mirrors, pictures and a clock on the walls.
#include "samples/room/furniture.h"
#include "samples/room/swept.h"
#include "samples/trigonometry.h"

#include <array>
#include <numbers>
#include <utility>

namespace firsthit {
namespace {

/// A frame around the middle, in the plane z = 0.
Shape frame_shape(const glm::dvec2& half, double width)
{
    Shape frame;
    for (const double side : {-1.0, 1.0}) {
        add_rounded_box(frame, {half.x + 2 * width, width, 0.014}, 0.007, 2,
            moved(0, side * (half.y + width), 0.014));
        add_rounded_box(
            frame, {width, half.y, 0.013}, 0.006, 2, moved(side * (half.x + width), 0, 0.013));
    }
    return frame;
}

/// A flat sheet in the plane z = depth, which looks along z.
Shape pane_shape(const glm::dvec2& half, double depth, std::vector<glm::vec2>& uv)
{
    Shape pane;
    uv = add_sheet(pane, 1, 1, [&](double u, double v) {
        return glm::dvec3(half.x * (2 * u - 1), half.y * (2 * v - 1), depth);
    });
    return pane;
}

struct Hanging {
    const char* name;
    glm::dmat4 place;
    glm::dvec2 half;
    double width;
    std::uint32_t pane, frame;
};

void hang(RoomScene& room, const Hanging& thing)
{
    const std::int32_t node = room.add_node(thing.name, -1, thing.place);
    Shape frame = frame_shape(thing.half, thing.width);
    std::vector<glm::vec2> uv = box_mapping(frame, 1.0);
    room.add(
        room.add_node("frame", node, glm::dmat4(1)), thing.frame, std::move(frame), std::move(uv));
    Shape pane = pane_shape(thing.half, 0.008, uv);
    room.add(
        room.add_node("pane", node, glm::dmat4(1)), thing.pane, std::move(pane), std::move(uv));
}

void add_clock(RoomScene& room)
{
    const RoomMaterials& m = room.materials();
    const std::int32_t node = room.add_node("clock", -1, moved(0.40, 1.95, -kRoomHalf.z + 0.002));
    const glm::dmat4 to_wall = moved(0, 0, 0, {1, 0, 0}, std::numbers::pi / 2);
    Shape rim;
    add_lathe(rim,
        std::to_array<Outline>({{0, 0.012}, {0.140, 0.012}, {0.144, 0.030}, {0.152, 0.034},
            {0.160, 0.028}, {0.162, 0.0}, {0.162, 0.0}, {0, 0.0}}),
        56, to_wall);
    room.add(node, m.walnut, std::move(rim));
    Shape face;
    add_lathe(face,
        std::to_array<Outline>({{0, 0.016}, {0.139, 0.016}, {0.139, 0.016}, {0.139, 0.013},
            {0.139, 0.013}, {0, 0.013}}),
        56, to_wall);
    room.add(node, m.porcelain, std::move(face));
    Shape hands;
    for (int hour = 0; hour < 12; ++hour)
        add_box(hands, {hour % 3 == 0 ? 0.005 : 0.0025, 0.011, 0.0008},
            moved(0, 0, 0.0175, {0, 0, 1}, std::numbers::pi / 6 * hour) * moved(0, 0.118, 0));
    add_box(
        hands, {0.0045, 0.040, 0.0008}, moved(0, 0, 0.020, {0, 0, 1}, 1.05) * moved(0, 0.032, 0));
    add_box(
        hands, {0.0032, 0.058, 0.0008}, moved(0, 0, 0.0225, {0, 0, 1}, -0.95) * moved(0, 0.048, 0));
    room.add(node, m.iron, std::move(hands));
}

} // namespace

void add_wall_things(RoomScene& room)
{
    const RoomMaterials& m = room.materials();
    const double z = -kRoomHalf.z + 0.001, x = kRoomHalf.x - 0.001, quarter = std::numbers::pi / 2;
    const glm::dvec3 up(0, 1, 0);
    hang(room, {"mirror", moved(1.55, 1.55, z), {0.50, 0.36}, 0.025, m.mirror, m.brass});
    hang(room, {"tall mirror", moved(x, 1.05, -0.55, up, -quarter), {0.34, 0.85}, 0.03, m.mirror,
                   m.walnut});
    hang(room, {"landscape", moved(x, 1.60, 0.75, up, -quarter), {0.42, 0.30}, 0.03, m.landscape,
                   m.walnut});
    hang(room, {"poster", moved(-kRoomHalf.x + 0.001, 1.62, 1.55, up, quarter), {0.26, 0.36}, 0.015,
                   m.poster, m.white});
    hang(room, {"small landscape", moved(-1.95, 1.62, z), {0.22, 0.16}, 0.02, m.landscape, m.oak});
    add_clock(room);
}

} // namespace firsthit
