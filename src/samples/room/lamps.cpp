// lamps.cpp - lamps and the six lights in them.
//
// Shades are open above and below, and nothing hides a light from all sides: it is beside its bulb.
#include "samples/room/furniture.h"
#include "samples/room/swept.h"
#include "samples/trigonometry.h"

#include <array>
#include <numbers>
#include <string>
#include <utility>

namespace firsthit {
namespace {

/// A light of this power, seen in the colour of a warm bulb.
void add_lamp_light(RoomScene& room, const char* name, const glm::dvec3& place, float power)
{
    room.builder().add_light({.position = place,
        .color = power * glm::vec3(1.0f, 0.76f, 0.48f),
        .inverse_square = true,
        .name = name});
}

/// A shade between two rings, open above and below.
Shape shade_shape(double top_radius, double foot_radius, double height)
{
    constexpr double kThick = 0.002;
    Shape shade;
    add_lathe(shade,
        std::to_array<Outline>({{top_radius, height}, {foot_radius, 0}, {foot_radius, 0},
            {foot_radius - kThick, 0}, {foot_radius - kThick, 0}, {top_radius - kThick, height},
            {top_radius - kThick, height}, {top_radius, height}}),
        48);
    return shade;
}

void add_pendant(RoomScene& room)
{
    const RoomMaterials& m = room.materials();
    constexpr double kRim = 1.62;
    const std::int32_t node =
        room.add_node("pendant lamp", -1, moved(kTablePlace.x, 0, kTablePlace.z));
    Shape bell;
    add_lathe(bell,
        std::to_array<Outline>({{0, 0.215}, {0.030, 0.213}, {0.045, 0.200}, {0.050, 0.180},
            {0.095, 0.135}, {0.165, 0.065}, {0.205, 0.000}, {0.207, -0.003}, {0.203, -0.003},
            {0.160, 0.062}, {0.090, 0.130}, {0.040, 0.172}, {0, 0.178}}),
        48, moved(0, kRim, 0));
    room.add(node, m.iron, std::move(bell));
    Shape cord;
    add_rod(cord, {0, kRim + 0.21, 0}, {0, 2 * kRoomHalf.y - 0.005, 0}, 0.004, 8);
    add_lathe(cord,
        std::to_array<Outline>({{0, 0.0}, {0.045, 0.0}, {0.045, 0.0}, {0.040, -0.02}, {0, -0.03}}),
        24, moved(0, 2 * kRoomHalf.y - 0.001, 0));
    room.add(node, m.iron, std::move(cord));
    Shape bulb;
    add_ellipsoid(bulb, {0.030, 0.036, 0.030}, 20, moved(0, kRim + 0.110, 0));
    room.add(node, m.bulb, std::move(bulb));
    add_lamp_light(room, "pendant", {kTablePlace.x, kRim + 0.055, kTablePlace.z}, 1.45f);
}

void add_floor_lamp(RoomScene& room)
{
    const RoomMaterials& m = room.materials();
    const glm::dvec3 at(-2.66, 0, 2.10);
    const std::int32_t node = room.add_node("floor lamp", -1, moved(at.x, at.y, at.z));
    Shape stand;
    add_lathe(stand,
        std::to_array<Outline>({{0, 1.46}, {0.008, 1.46}, {0.009, 0.05}, {0.016, 0.035},
            {0.12, 0.022}, {0.135, 0.012}, {0.135, 0.001}, {0.135, 0.001}, {0, 0.001}}),
        32);
    room.add(node, m.brass, std::move(stand));
    room.add(node, m.shade, [] {
        Shape shade = shade_shape(0.14, 0.21, 0.26);
        for (glm::vec3& p : shade.position) p.y += 1.42f;
        return shade;
    }());
    Shape bulb;
    add_ellipsoid(bulb, {0.028, 0.032, 0.028}, 18, moved(0, 1.49, 0));
    room.add(node, m.bulb, std::move(bulb));
    add_lamp_light(room, "floor lamp", at + glm::dvec3(0, 1.57, 0), 1.0f);
}

void add_table_lamp(RoomScene& room)
{
    const RoomMaterials& m = room.materials();
    const glm::dvec3 at(1.02, 0.82, -2.28);
    const std::int32_t node = room.add_node("table lamp", -1, moved(at.x, at.y, at.z));
    Shape foot;
    add_lathe(foot,
        std::to_array<Outline>({{0, 0.25}, {0.010, 0.25}, {0.011, 0.21}, {0.022, 0.20},
            {0.052, 0.16}, {0.064, 0.11}, {0.056, 0.06}, {0.034, 0.025}, {0.050, 0.012},
            {0.054, 0.0005}, {0.054, 0.0005}, {0, 0.0005}}),
        40);
    room.add(node, m.blue_glaze, std::move(foot));
    Shape shade = shade_shape(0.08, 0.135, 0.17);
    for (glm::vec3& p : shade.position) p.y += 0.24f;
    room.add(node, m.shade, std::move(shade));
    add_lamp_light(room, "table lamp", at + glm::dvec3(0, 0.335, 0), 0.42f);
}

/// A half bowl on the wall that lights the ceiling and the wall above it.
void add_sconce(RoomScene& room, const char* name, const glm::dmat4& place)
{
    const RoomMaterials& m = room.materials();
    const std::int32_t node = room.add_node(name, -1, place);
    Shape bowl;
    add_lathe(bowl,
        std::to_array<Outline>({{0, 0.012}, {0.030, 0.016}, {0.062, 0.042}, {0.080, 0.080},
            {0.082, 0.082}, {0.084, 0.080}, {0.066, 0.038}, {0.034, 0.008}, {0, 0.002}}),
        40, moved(0, 0, 0.11));
    room.add(node, m.shade, std::move(bowl));
    Shape arm;
    add_tube(arm,
        std::to_array<TubePoint>({{{0, -0.04, 0.002}, 0.007}, {{0, -0.045, 0.05}, 0.007},
            {{0, -0.035, 0.09}, 0.007}, {{0, 0.004, 0.11}, 0.007}}),
        {.sides = 12, .across = {1, 0, 0}});
    add_lathe(arm,
        std::to_array<Outline>({{0, 0.010}, {0.030, 0.008}, {0.034, 0.0}, {0.034, 0.0}, {0, 0.0}}),
        24, moved(0, -0.04, 0.001, {1, 0, 0}, std::numbers::pi / 2));
    room.add(node, m.brass, std::move(arm));
    add_lamp_light(room, name, glm::dvec3(place * glm::dvec4(0, 0.070, 0.11, 1)), 0.36f);
}

/// A lantern of bars and crossed slats, which throws its pattern at the walls.
void add_lantern(RoomScene& room)
{
    const RoomMaterials& m = room.materials();
    constexpr double kHalf = 0.105, kHeight = 0.30;
    const glm::dvec3 at(2.42, 1.62, -1.92);
    const std::int32_t node = room.add_node("lantern", -1, moved(at.x, at.y, at.z, {0, 1, 0}, 0.5));
    Shape frame;
    for (const double y : {0.0, kHeight})
        for (const double side : {-1.0, 1.0}) {
            add_rounded_box(
                frame, {kHalf + 0.008, 0.008, 0.008}, 0.003, 1, moved(0, y, side * kHalf));
            add_rounded_box(
                frame, {0.008, 0.008, kHalf - 0.008}, 0.003, 1, moved(side * kHalf, y, 0));
        }
    for (const double x : {-1.0, 1.0})
        for (const double z : {-1.0, 1.0})
            add_rounded_box(frame, {0.008, kHeight / 2 - 0.008, 0.008}, 0.003, 1,
                moved(x * kHalf, kHeight / 2, z * kHalf));
    add_rod(frame, {0, kHeight + 0.10, 0}, {0, 2 * kRoomHalf.y - at.y - 0.002, 0}, 0.003, 8);
    for (const double x : {-1.0, 1.0})
        for (const double z : {-1.0, 1.0})
            add_rod(frame, {x * kHalf, kHeight, z * kHalf}, {0, kHeight + 0.11, 0}, 0.004, 8);
    room.add(node, m.iron, std::move(frame));

    // Crossed slats on all four sides.
    Shape slats;
    for (int side = 0; side < 4; ++side) {
        const glm::dmat4 turn = moved(0, 0, 0, {0, 1, 0}, std::numbers::pi / 2 * side);
        for (int k = 0; k < 8; ++k)
            for (const double lean : {-1.0, 1.0}) {
                const double foot = kHalf * (2 * (k + 0.5) / 8 - 1), head = foot + lean * 0.07;
                const double end = head > kHalf ? kHalf : head < -kHalf ? -kHalf : head;
                const double height = kHeight * (end - foot) / (head - foot);
                add_tube(slats,
                    std::to_array<TubePoint>({{{foot, 0.004, kHalf + 0.002 * lean}, 0.0035},
                        {{end, height - 0.004, kHalf + 0.002 * lean}, 0.0035}}),
                    {.sides = 6, .across = {0, 0, 1}}, turn);
            }
    }
    room.add(node, m.lantern_paper, std::move(slats));
    add_lamp_light(room, "lantern", at + glm::dvec3(0, 0.16, 0), 0.58f);
}

} // namespace

void add_lamps(RoomScene& room)
{
    add_pendant(room);
    add_floor_lamp(room);
    add_table_lamp(room);
    add_sconce(room, "sconce left", moved(-1.95, 1.98, -kRoomHalf.z));
    add_sconce(
        room, "sconce right", moved(kRoomHalf.x, 1.85, 1.55, {0, 1, 0}, -std::numbers::pi / 2));
    add_lantern(room);
}

} // namespace firsthit
