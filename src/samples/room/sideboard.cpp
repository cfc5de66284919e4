// sideboard.cpp - the sideboard with drawers, handles and legs.
#include "samples/room/furniture.h"
#include "samples/room/swept.h"

#include <array>
#include <utility>

namespace firsthit {
namespace {

constexpr double kHalfWidth = 0.75, kHalfDepth = 0.20; // m
constexpr double kLow = 0.20, kTop = 0.82;             // m above the floor

void add_handle(Shape& handles, double x, double y)
{
    const double z = kHalfDepth + 0.008;
    add_tube(handles,
        std::to_array<TubePoint>({{{x - 0.052, y, z}, 0.005}, {{x - 0.048, y, z + 0.018}, 0.0048},
            {{x - 0.036, y, z + 0.026}, 0.0045}, {{x, y, z + 0.028}, 0.0045},
            {{x + 0.036, y, z + 0.026}, 0.0045}, {{x + 0.048, y, z + 0.018}, 0.0048},
            {{x + 0.052, y, z}, 0.005}}),
        {.sides = 10, .across = {0, 1, 0}});
    for (const double side : {-1.0, 1.0})
        add_lathe(handles,
            std::to_array<Outline>(
                {{0, 0.003}, {0.009, 0.002}, {0.011, 0.0}, {0.011, 0.0}, {0, 0.0}}),
            14, moved(x + side * 0.052, y, z - 0.001, {1, 0, 0}, 1.5707963267948966));
}

} // namespace

void add_sideboard(RoomScene& room)
{
    const RoomMaterials& m = room.materials();
    const std::int32_t node =
        room.add_node("sideboard", -1, moved(1.55, 0, -kRoomHalf.z + kHalfDepth + 0.02));
    Shape body;
    const double half_y = (kTop - kLow) / 2;
    add_rounded_box(body, {kHalfWidth - 0.02, half_y - 0.01, kHalfDepth - 0.01}, 0.004, 1,
        moved(0, kLow + half_y - 0.01, -0.005));
    add_rounded_box(
        body, {kHalfWidth, 0.014, kHalfDepth + 0.005}, 0.006, 3, moved(0, kTop - 0.014, 0));
    Shape handles;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) {
            const double x = 0.475 * (column - 1), y = kLow + 0.105 + 0.188 * row;
            add_rounded_box(body, {0.228, 0.086, 0.010}, 0.004, 1, moved(x, y, kHalfDepth));
            add_handle(handles, x, y + 0.02);
        }
    std::vector<glm::vec2> uv = box_mapping(body, 1.0);
    room.add(node, m.walnut, std::move(body), std::move(uv));
    room.add(node, m.brass, std::move(handles));

    Shape legs;
    for (const double x : {-1.0, 1.0})
        for (const double z : {-1.0, 1.0})
            add_tube(legs,
                std::to_array<TubePoint>(
                    {{{x * (kHalfWidth - 0.04), 0.001, z * (kHalfDepth - 0.03)}, 0.010},
                        {{x * (kHalfWidth - 0.12), kLow + 0.005, z * (kHalfDepth - 0.06)}, 0.020}}),
                {.sides = 16, .across = {1, 0, 0}});
    uv = box_mapping(legs, 1.0);
    room.add(node, m.walnut, std::move(legs), std::move(uv));
}

} // namespace firsthit
