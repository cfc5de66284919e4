// plant.cpp - the plant in the corner: a pot, stems and leaves on stalks.
#include "samples/room/furniture.h"
#include "samples/room/textures/painted_texture.h"
#include "samples/room/swept.h"
#include "samples/trigonometry.h"

#include <glm/geometric.hpp>

#include <array>
#include <utility>

namespace firsthit {
namespace {

constexpr int kLeaves = 126;
constexpr double kGoldenAngle = 2.399963229728653; // rad, from leaf to leaf around a stem

void add_pot(RoomScene& room, std::int32_t node)
{
    Shape pot;
    add_lathe(pot,
        std::to_array<Outline>({{0, 0.30}, {0.165, 0.30}, {0.170, 0.335}, {0.176, 0.345},
            {0.190, 0.345}, {0.194, 0.335}, {0.192, 0.300}, {0.184, 0.290}, {0.150, 0.04},
            {0.146, 0.025}, {0.146, 0.001}, {0.146, 0.001}, {0, 0.001}}),
        48);
    room.add(node, room.materials().clay, std::move(pot));
    Shape soil;
    add_ellipsoid(soil, {0.166, 0.020, 0.166}, 32, moved(0, 0.302, 0));
    room.add(node, room.materials().soil, std::move(soil));
}

/// Where one of three stems is, u from the soil up.
glm::dvec3 stem_at(int stem, double u)
{
    const auto [s, c] = sine_cosine(2.0943951023931953 * stem + 1.3 + 1.4 * u);
    const double out = 0.035 + 0.10 * u * u + 0.02 * stem * u;
    return {out * c, 0.30 + (1.12 + 0.16 * stem) * u, out * s};
}

/// A leaf and its stalk. The leaf hangs the more the farther it is from the stem.
void add_leaf(Shape& leaves, Shape& stems, int number)
{
    const int stem = number % 3;
    const double u = 0.26 + 0.74 * (number / 3) / (kLeaves / 3 - 1.0);
    const glm::dvec3 from = stem_at(stem, u);
    const auto [s, c] = sine_cosine(kGoldenAngle * number);
    const glm::dvec3 out(c, 0, s), up(0, 1, 0), side(-s, 0, c);
    const double own = chance(number, 101), rise = 0.20 + 0.75 * u * u - 0.25 * own;

    const glm::dvec3 start = from + (0.05 + 0.09 * (1.1 - u)) * out + (0.02 + 0.07 * rise) * up;
    const glm::dvec3 bow = 0.5 * (from + start) + 0.012 * up;
    add_tube(stems, std::to_array<TubePoint>({{from, 0.0030}, {bow, 0.0024}, {start, 0.0018}}),
        {.sides = 4, .across = side});

    const double length = (0.15 + 0.07 * chance(number, 102)) * (1.15 - 0.35 * u);
    const double width = length * (0.26 + 0.06 * own);
    const double roll = 0.8 * (chance(number, 103) - 0.5);
    add_sheet(leaves, 4, 7, [&](double across, double v) {
        const double x = 2 * across - 1;
        const double profile = 3.4 * v * (1 - v) * (1 - 0.45 * v) + 0.012;
        const double fold = 0.28 * (x < 0 ? -x : x) + roll * x;
        return start + out * (length * (v - 0.12 * rise * v * v)) +
               up * (length * (rise * v - (0.55 + 0.35 * own) * v * v) + width * profile * fold) +
               side * (width * profile * x);
    });
}

} // namespace

void add_plant(RoomScene& room)
{
    const std::int32_t node = room.add_node("plant", -1, moved(-2.42, 0, -1.98));
    add_pot(room, node);
    Shape leaves, stems;
    for (int stem = 0; stem < 3; ++stem) {
        std::vector<TubePoint> path;
        for (int k = 0; k <= 24; ++k)
            path.push_back({stem_at(stem, k / 24.0), 0.016 - 0.010 * k / 24.0});
        add_tube(stems, path, {.sides = 10, .across = {1, 0, 0}});
    }
    for (int leaf = 0; leaf < kLeaves; ++leaf) add_leaf(leaves, stems, leaf);
    room.add(room.add_node("stems", node, glm::dmat4(1)), room.materials().bark, std::move(stems));
    room.add(
        room.add_node("leaves", node, glm::dmat4(1)), room.materials().leaf, std::move(leaves));
}

} // namespace firsthit
