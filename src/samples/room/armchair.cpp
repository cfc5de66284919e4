// armchair.cpp - an armchair with cushions, and a small table beside it.
#include "samples/room/furniture.h"
#include "samples/room/swept.h"

#include <array>
#include <utility>

namespace firsthit {
namespace {

void add_upholstery(RoomScene& room, std::int32_t node)
{
    // It looks along z.
    Shape chair;
    add_rounded_box(chair, {0.36, 0.10, 0.36}, 0.06, 4, moved(0, 0.28, 0));
    add_rounded_box(chair, {0.29, 0.075, 0.33}, 0.065, 4, moved(0, 0.43, 0.04));
    add_rounded_box(chair, {0.30, 0.34, 0.085}, 0.08, 4, moved(0, 0.68, -0.31, {1, 0, 0}, -0.20));
    for (const double side : {-1.0, 1.0}) {
        add_rounded_box(chair, {0.075, 0.20, 0.36}, 0.07, 4, moved(side * 0.37, 0.42, 0.0));
        add_rounded_box(
            chair, {0.05, 0.20, 0.14}, 0.045, 4, moved(side * 0.30, 0.78, -0.30, {1, 0, 0}, -0.20));
    }
    std::vector<glm::vec2> uv = box_mapping(chair, 0.2);
    room.add(node, room.materials().mustard, std::move(chair), std::move(uv));

    Shape cushion;
    add_rounded_box(
        cushion, {0.20, 0.17, 0.060}, 0.058, 5, moved(0.04, 0.68, -0.13, {0.95, 0.1, 0.25}, -0.34));
    uv = box_mapping(cushion, 0.2);
    room.add(node, room.materials().cushion, std::move(cushion), std::move(uv));

    Shape legs;
    for (const double x : {-1.0, 1.0})
        for (const double z : {-1.0, 1.0})
            add_tube(legs,
                std::to_array<TubePoint>(
                    {{{x * 0.33, 0.001, z * 0.33}, 0.012}, {{x * 0.29, 0.20, z * 0.29}, 0.020}}),
                {.sides = 16, .across = {1, 0, 0}});
    room.add(node, room.materials().walnut, std::move(legs));
}

void add_side_table(RoomScene& room)
{
    const std::int32_t node = room.add_node("side table", -1, moved(-2.35, 0, 0.62));
    Shape table;
    add_lathe(table,
        std::to_array<Outline>({{0, 0.500}, {0.205, 0.500}, {0.210, 0.495}, {0.210, 0.485},
            {0.205, 0.480}, {0, 0.480}}),
        48);
    for (int leg = 0; leg < 3; ++leg) {
        const glm::dmat4 turn = moved(0, 0, 0, {0, 1, 0}, 2.0943951023931953 * leg + 0.4);
        add_tube(table,
            std::to_array<TubePoint>({{{0.19, 0.001, 0}, 0.010}, {{0.10, 0.485, 0}, 0.013}}),
            {.sides = 12, .across = {0, 0, 1}}, turn);
    }
    std::vector<glm::vec2> uv = box_mapping(table, 1.0);
    room.add(node, room.materials().birch, std::move(table), std::move(uv));

    // Two books, lying.
    Shape books;
    add_rounded_box(
        books, {0.075, 0.012, 0.11}, 0.004, 2, moved(0.01, 0.5125, 0.0, {0, 1, 0}, 0.3));
    add_rounded_box(
        books, {0.068, 0.010, 0.10}, 0.004, 2, moved(0.0, 0.535, 0.01, {0, 1, 0}, -0.2));
    room.add(node, room.materials().toys[2], std::move(books));
}

} // namespace

void add_armchair(RoomScene& room)
{
    add_upholstery(room, room.add_node("armchair", -1, moved(-2.22, 0, 1.45, {0, 1, 0}, 1.95)));
    add_side_table(room);
}

} // namespace firsthit
