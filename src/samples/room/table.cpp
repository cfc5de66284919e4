// table.cpp - the table and the rug under it.
#include "samples/room/furniture.h"
#include "samples/room/textures/painted_texture.h"
#include "samples/room/swept.h"

#include <array>
#include <utility>

namespace firsthit {

void add_rug(RoomScene& room)
{
    constexpr double kHalfX = 1.20, kHalfZ = 0.80, kThick = 0.006;
    const std::int32_t node = room.add_node("rug", -1, moved(kTablePlace.x, 0, kTablePlace.z));
    Shape rug;
    add_rounded_box(rug, {kHalfX, kThick, kHalfZ}, 0.004, 2, moved(0, kThick, 0));
    std::vector<glm::vec2> uv;
    for (const glm::vec3& p : rug.position)
        uv.emplace_back(0.5 + 0.5 * p.x / kHalfX, 0.5 - 0.5 * p.z / kHalfZ);
    room.add(node, room.materials().rug, std::move(rug), std::move(uv));

    // Tassels at both short sides, each lying a little differently.
    Shape fringe;
    constexpr int kTassels = 48;
    for (const double side : {-1.0, 1.0})
        for (int k = 0; k < kTassels; ++k) {
            const double z = kHalfZ * (2 * (k + 0.5) / kTassels - 1);
            const double lean = 0.02 * (chance(k, side > 0 ? 81 : 82) - 0.5);
            add_tube(fringe,
                std::to_array<TubePoint>({{{side * (kHalfX - 0.01), 0.008, z}, 0.0035},
                    {{side * (kHalfX + 0.025), 0.006, z + 0.4 * lean}, 0.0035},
                    {{side * (kHalfX + 0.065), 0.004, z + lean}, 0.003}}),
                {.sides = 4});
        }
    room.add(node, room.materials().fringe, std::move(fringe));
}

void add_table(RoomScene& room)
{
    constexpr double kHalfX = 0.80, kHalfZ = 0.45;
    const std::int32_t node = room.add_node("table", -1, moved(kTablePlace.x, 0, kTablePlace.z));
    Shape table;
    // A top of five boards.
    for (int k = 0; k < 5; ++k)
        add_rounded_box(table, {kHalfX, 0.016, kHalfZ / 5 - 0.0012}, 0.006, 2,
            moved(0, kTableTop - 0.016, kHalfZ * (2 * (k + 0.5) / 5 - 1)));
    for (const double side : {-1.0, 1.0}) {
        add_rounded_box(table, {kHalfX - 0.09, 0.045, 0.011}, 0.004, 2,
            moved(0, kTableTop - 0.078, side * (kHalfZ - 0.07)));
        add_rounded_box(table, {0.011, 0.045, kHalfZ - 0.09}, 0.004, 2,
            moved(side * (kHalfX - 0.07), kTableTop - 0.078, 0));
    }
    std::vector<glm::vec2> uv = box_mapping(table, 1.0);
    room.add(node, room.materials().oak, std::move(table), std::move(uv));

    // Turned legs.
    Shape leg;
    add_rounded_box(leg, {0.034, 0.07, 0.034}, 0.005, 2, moved(0, 0.635, 0));
    add_lathe(leg,
        std::to_array<Outline>({{0, 0.57}, {0.026, 0.57}, {0.031, 0.557}, {0.026, 0.544},
            {0.021, 0.535}, {0.030, 0.515}, {0.033, 0.48}, {0.030, 0.40}, {0.024, 0.28},
            {0.020, 0.16}, {0.019, 0.13}, {0.027, 0.115}, {0.027, 0.10}, {0.019, 0.085},
            {0.022, 0.04}, {0.028, 0.018}, {0.026, 0.012}, {0.026, 0.012}, {0, 0.012}}),
        16);
    uv = box_mapping(leg, 1.0);
    const std::uint32_t mesh = room.add_mesh(std::move(leg), std::move(uv));
    for (const double x : {-1.0, 1.0})
        for (const double z : {-1.0, 1.0})
            room.place(mesh,
                room.add_node(
                    "table leg", node, moved(x * (kHalfX - 0.07), 0, z * (kHalfZ - 0.07))),
                room.materials().oak);
}

} // namespace firsthit
