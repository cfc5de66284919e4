// toys.cpp - building blocks, a ball, and a tower of rings.
#include "samples/room/furniture.h"
#include "samples/room/swept.h"
#include "samples/trigonometry.h"

#include <array>
#include <numbers>
#include <utility>

namespace firsthit {

void add_toys(RoomScene& room)
{
    const RoomMaterials& m = room.materials();
    const std::int32_t node = room.add_node("toys", -1, moved(2.02, 0, -0.98));

    // Blocks: a small gate, and some that lie about.
    Shape cube;
    add_rounded_box(cube, glm::dvec3(0.035), 0.004, 2);
    const std::uint32_t block = room.add_mesh(std::move(cube));
    struct BlockPlace {
        double x, y, z, turn;
        std::size_t color;
    };
    constexpr std::array<BlockPlace, 9> kPlaces{{{0, 0.0355, 0, 0.2, 0},
        {0.16, 0.0355, 0.03, 0.2, 2}, {0.0, 0.1060, 0, 0.35, 1}, {0.16, 0.1060, 0.03, 0.1, 3},
        {0.05, 0.0355, 0.22, 0.9, 3}, {-0.16, 0.0355, 0.14, 1.3, 2}, {0.30, 0.0355, 0.16, 0.5, 0},
        {-0.08, 0.0355, -0.20, 0.7, 1}, {0.34, 0.0355, -0.14, 0.1, 1}}};
    for (const BlockPlace& at : kPlaces)
        room.place(block, room.add_node("block", node, moved(at.x, at.y, at.z, {0, 1, 0}, at.turn)),
            m.toys[at.color]);
    Shape beam;
    add_rounded_box(
        beam, {0.125, 0.018, 0.033}, 0.004, 2, moved(0.08, 0.1595, 0.015, {0, 1, 0}, -0.18));
    room.add(room.add_node("beam", node, glm::dmat4(1)), m.birch, std::move(beam));

    Shape ball;
    add_ellipsoid(ball, glm::dvec3(0.085), 28, moved(0.26, 0.0855, -0.34));
    room.add(room.add_node("ball", node, glm::dmat4(1)), m.toys[3], std::move(ball));

    // Rings on a pole.
    const std::int32_t tower = room.add_node("rings", node, moved(0.52, 0, 0.10));
    Shape pole;
    add_lathe(pole,
        std::to_array<Outline>({{0, 0.20}, {0.010, 0.196}, {0.012, 0.185}, {0.012, 0.02},
            {0.075, 0.018}, {0.078, 0.010}, {0.076, 0.001}, {0.076, 0.001}, {0, 0.001}}),
        28);
    room.add(tower, m.birch, std::move(pole));
    for (int k = 0; k < 5; ++k) {
        const double radius = 0.052 - 0.006 * k;
        std::vector<TubePoint> path;
        for (int step = 0; step < 22; ++step) {
            const auto [s, c] = sine_cosine(2 * std::numbers::pi * step / 22);
            path.push_back({{radius * c, 0.036 + 0.031 * k, radius * s}, 0.0155});
        }
        Shape ring;
        add_tube(ring, path, {.sides = 9, .ring = true});
        room.add(room.add_node("ring", tower, glm::dmat4(1)),
            m.toys[static_cast<std::size_t>(k) % m.toys.size()], std::move(ring));
    }
}

} // namespace firsthit
