// window.cpp - the window's frame and bars, its blind and curtains.
#include "samples/room/furniture.h"
#include "samples/room/swept.h"
#include "samples/room/window_place.h"
#include "samples/trigonometry.h"

#include <numbers>
#include <utility>

namespace firsthit {
namespace {

void add_frame(RoomScene& room, std::int32_t node)
{
    const WindowPlace w = window_place();
    const double x = -kRoomHalf.x - 0.10, z = w.middle_z(), y = 0.5 * (w.sill + w.head);
    const double half_z = w.half_z(), half_y = 0.5 * (w.head - w.sill);
    Shape frame;
    for (const double side : {-1.0, 1.0}) {
        add_rounded_box(
            frame, {0.03, half_y, 0.03}, 0.006, 2, moved(x, y, z + side * (half_z - 0.03)));
        add_rounded_box(
            frame, {0.03, 0.03, half_z - 0.06}, 0.006, 2, moved(x, y + side * (half_y - 0.03), z));
    }
    add_rounded_box(frame, {0.03, half_y - 0.06, 0.035}, 0.006, 2, moved(x, y, z));
    // Bars of both casements: a lattice of three rows.
    for (const double casement : {-0.5, 0.5}) {
        add_rounded_box(
            frame, {0.012, half_y - 0.06, 0.012}, 0.004, 1, moved(x, y, z + casement * half_z));
        for (const double row : {-1.0, 1.0})
            add_rounded_box(frame, {0.012, 0.012, half_z / 2 - 0.05}, 0.004, 1,
                moved(x, y + row * half_y / 3, z + casement * half_z));
    }
    add_rounded_box(frame, {0.16, 0.018, half_z + 0.10}, 0.012, 3,
        moved(-kRoomHalf.x + 0.08, w.sill - 0.020, z)); // the sill
    room.add(node, room.materials().white, std::move(frame));

    Shape latch;
    add_rod(latch, {x + 0.03, y, z}, {x + 0.07, y, z}, 0.010, 10);
    add_rod(latch, {x + 0.065, y + 0.01, z}, {x + 0.065, y - 0.10, z}, 0.008, 10);
    room.add(node, room.materials().brass, std::move(latch));
}

/// Slats that let the sun through in stripes, drawn up from the lower part of the window.
void add_blind(RoomScene& room, std::int32_t node)
{
    const WindowPlace w = window_place();
    const double x = -kRoomHalf.x - 0.02, z = w.middle_z(), half_z = w.half_z() - 0.02;
    constexpr int kSlats = 16;
    constexpr double kStep = 0.048;
    Shape slats;
    add_rounded_box(slats, {0.025, 0.02, half_z}, 0.006, 2, moved(x, w.head - 0.022, z));
    for (int k = 0; k < kSlats; ++k)
        add_rounded_box(slats, {0.023, 0.0014, half_z}, 0.0012, 2,
            moved(x, w.head - 0.075 - kStep * k, z, {0, 0, 1}, 0.12));
    add_rounded_box(
        slats, {0.022, 0.008, half_z}, 0.006, 2, moved(x, w.head - 0.075 - kStep * kSlats, z));
    room.add(node, room.materials().birch, std::move(slats));

    Shape cords;
    for (const double side : {-0.75, 0.0, 0.75}) {
        const double at = z + side * half_z;
        for (const double dx : {-0.024, 0.024})
            add_rod(cords, {x + dx, w.head - 0.04, at},
                {x + dx, w.head - 0.075 - kStep * kSlats, at}, 0.0012, 5);
    }
    add_rod(cords, {x + 0.03, w.head - 0.04, z + half_z - 0.06},
        {x + 0.03, w.sill + 0.35, z + half_z - 0.06}, 0.0015, 5);
    room.add(node, room.materials().linen, std::move(cords));
}

/// One curtain, gathered: folds that grow towards its foot.
Shape curtain_shape(std::vector<glm::vec2>& uv)
{
    constexpr double kWidth = 0.46, kHeight = 2.28;
    Shape curtain;
    uv = add_sheet(curtain, 63, 16, [](double u, double v) {
        const double fold = 2 * std::numbers::pi * u * 7;
        const double depth = 0.015 + 0.020 * v;
        return glm::dvec3(depth * sine(fold) + 0.008 * sine(1.37 * fold + 4 * v), kHeight * (1 - v),
            kWidth * (u - 0.5) * (0.90 + 0.12 * v) + 0.004 * cosine(fold));
    });
    for (glm::vec2& at : uv) at *= glm::vec2(6, 11);
    return curtain;
}

void add_curtains(RoomScene& room, std::int32_t node)
{
    const WindowPlace w = window_place();
    const double x = -kRoomHalf.x + 0.10;
    std::vector<glm::vec2> uv;
    Shape shape = curtain_shape(uv);
    const std::uint32_t mesh = room.add_mesh(std::move(shape), std::move(uv));
    for (const double z : {w.low_z - 0.16, w.high_z + 0.16})
        room.place(mesh, room.add_node("curtain", node, moved(x, 0.04, z)), room.materials().linen);

    Shape rail;
    add_rod(rail, {x, 2.36, w.low_z - 0.45}, {x, 2.36, w.high_z + 0.45}, 0.014, 14);
    for (const double z : {w.low_z - 0.45, w.high_z + 0.45})
        add_ellipsoid(rail, glm::dvec3(0.030), 16, moved(x, 2.36, z));
    for (const double z : {w.low_z - 0.40, w.middle_z(), w.high_z + 0.40})
        add_rod(rail, {-kRoomHalf.x, 2.36, z}, {x, 2.36, z}, 0.009, 10);
    // Rings that hold the curtains.
    for (const double side : {w.low_z - 0.16, w.high_z + 0.16})
        for (int k = 0; k < 8; ++k) {
            const double z = side + 0.40 * (k / 7.0 - 0.5);
            const std::vector<TubePoint> ring = sample_path(10, 0.003, [&](double u) {
                const auto [s, c] = sine_cosine(2 * std::numbers::pi * u * 10 / 11);
                return glm::dvec3(x + 0.022 * c, 2.353 + 0.022 * s, z);
            });
            add_tube(rail, ring, {.sides = 4, .across = {0, 0, 1}, .ring = true});
        }
    room.add(node, room.materials().iron, std::move(rail));
}

} // namespace

void add_window(RoomScene& room)
{
    const std::int32_t node = room.add_node("window", -1, glm::dmat4(1));
    add_frame(room, node);
    add_blind(room, room.add_node("blind", node, glm::dmat4(1)));
    add_curtains(room, node);
}

} // namespace firsthit
