// crockery.cpp - kettle, cups, a glass and a bowl of fruit on the table.
#include "samples/room/furniture.h"
#include "samples/room/swept.h"
#include "samples/trigonometry.h"

#include <array>
#include <numbers>
#include <utility>

namespace firsthit {
namespace {

/// A part of a circle in the plane of x and y.
std::vector<TubePoint> arc(const glm::dvec3& middle, double radius, const glm::dvec2& angles_rad,
    double thickness, int steps)
{
    return sample_path(steps, thickness, [&](double u) {
        const auto [s, c] = sine_cosine(angles_rad.x + u * (angles_rad.y - angles_rad.x));
        return middle + radius * glm::dvec3(c, s, 0);
    });
}

void add_kettle(RoomScene& room, std::int32_t table)
{
    const std::int32_t node =
        room.add_node("kettle", table, moved(-0.10, 0, -0.08, {0, 1, 0}, 0.75));
    Shape kettle;
    add_lathe(kettle,
        std::to_array<Outline>({{0, 0.172}, {0.010, 0.171}, {0.014, 0.165}, {0.010, 0.159},
            {0.008, 0.152}, {0.020, 0.150}, {0.042, 0.144}, {0.050, 0.137}, {0.050, 0.134},
            {0.050, 0.134}, {0.056, 0.134}, {0.057, 0.130}, {0.066, 0.124}, {0.082, 0.108},
            {0.093, 0.086}, {0.098, 0.060}, {0.098, 0.040}, {0.094, 0.022}, {0.086, 0.010},
            {0.080, 0.006}, {0.080, 0.006}, {0.080, 0.001}, {0.080, 0.001}, {0, 0.001}}),
        56);
    // The spout, wide where it leaves the body.
    std::vector<TubePoint> spout;
    for (int k = 0; k <= 14; ++k) {
        const double u = k / 14.0;
        spout.push_back(
            {glm::dvec3(0.075 + 0.105 * u - 0.015 * u * u, 0.050 + 0.065 * u * u + 0.030 * u, 0),
                0.024 - 0.013 * u});
    }
    add_tube(kettle, spout, {.sides = 24, .across = {0, 0, 1}});
    room.add(node, room.materials().chrome, std::move(kettle));

    Shape handle;
    add_tube(handle, arc({0, 0.128, 0}, 0.072, {0.35, std::numbers::pi - 0.35}, 0.007, 28),
        {.sides = 14, .across = {0, 0, 1}});
    for (const double side : {-1.0, 1.0})
        add_rod(handle, {side * 0.068, 0.120, 0}, {side * 0.0675, 0.158, 0}, 0.006, 12);
    room.add(node, room.materials().iron, std::move(handle));
}

Shape cup_shape()
{
    Shape cup;
    add_lathe(cup,
        std::to_array<Outline>({{0, 0.012}, {0.018, 0.013}, {0.028, 0.020}, {0.035, 0.036},
            {0.038, 0.054}, {0.0395, 0.064}, {0.0405, 0.066}, {0.0420, 0.065}, {0.0415, 0.056},
            {0.038, 0.034}, {0.030, 0.016}, {0.021, 0.008}, {0.021, 0.004}, {0.021, 0.004},
            {0.018, 0.004}, {0.018, 0.004}, {0.017, 0.007}, {0, 0.007}}),
        28);
    add_tube(cup, arc({0.040, 0.038, 0}, 0.018, {-1.45, 1.45}, 0.0035, 16),
        {.sides = 8, .across = {0, 0, 1}});
    return cup;
}

Shape saucer_shape()
{
    Shape saucer;
    add_lathe(saucer,
        std::to_array<Outline>({{0, 0.0045}, {0.024, 0.0045}, {0.027, 0.0055}, {0.045, 0.008},
            {0.068, 0.015}, {0.070, 0.0155}, {0.070, 0.0140}, {0.046, 0.0045}, {0.030, 0.0006},
            {0.030, 0.0006}, {0, 0.0006}}),
        32);
    return saucer;
}

void add_cups(RoomScene& room, std::int32_t table)
{
    const std::uint32_t cup = room.add_mesh(cup_shape());
    const std::uint32_t saucer = room.add_mesh(saucer_shape());
    Shape filling;
    add_lathe(filling,
        std::to_array<Outline>({{0, 0.053}, {0.0365, 0.053}, {0.0365, 0.053}, {0.0355, 0.048},
            {0.0355, 0.048}, {0, 0.048}}),
        28);
    const std::uint32_t tea = room.add_mesh(std::move(filling));
    const RoomMaterials& m = room.materials();
    struct CupPlace {
        double x, z, turn;
        bool full, blue;
    };
    constexpr std::array<CupPlace, 4> kPlaces{
        {{-0.36, 0.27, 0.5, true, false}, {0.34, -0.28, 2.4, true, true},
            {-0.40, -0.26, 3.6, false, true}, {0.40, 0.24, -0.7, true, false}}};
    for (const CupPlace& at : kPlaces) {
        const std::int32_t node =
            room.add_node("cup", table, moved(at.x, 0, at.z, {0, 1, 0}, at.turn));
        room.place(saucer, node, at.blue ? m.blue_glaze : m.porcelain);
        const std::int32_t upper = room.add_node("cup on saucer", node, moved(0, 0.0010, 0));
        room.place(cup, upper, at.blue ? m.blue_glaze : m.porcelain);
        if (at.full) room.place(tea, upper, m.tea);
    }
}

void add_glass(RoomScene& room, std::int32_t table)
{
    Shape glass;
    add_lathe(glass,
        std::to_array<Outline>({{0, 0.012}, {0.022, 0.012}, {0.025, 0.014}, {0.0262, 0.018},
            {0.0310, 0.120}, {0.0315, 0.1225}, {0.0328, 0.1225}, {0.0332, 0.120}, {0.0290, 0.018},
            {0.0280, 0.004}, {0.0265, 0.001}, {0.0265, 0.001}, {0, 0.001}}),
        48);
    room.add(room.add_node("glass", table, moved(0.17, 0, 0.17)), room.materials().glass,
        std::move(glass));
}

void add_fruit(RoomScene& room, std::int32_t table)
{
    const std::int32_t node = room.add_node("fruit bowl", table, moved(0.33, 0, -0.03));
    Shape bowl;
    add_lathe(bowl,
        std::to_array<Outline>({{0, 0.020}, {0.040, 0.022}, {0.075, 0.034}, {0.102, 0.056},
            {0.118, 0.078}, {0.121, 0.080}, {0.124, 0.078}, {0.110, 0.052}, {0.082, 0.026},
            {0.050, 0.012}, {0.046, 0.001}, {0.046, 0.001}, {0, 0.001}}),
        44);
    room.add(node, room.materials().porcelain, std::move(bowl));

    Shape apple;
    add_lathe(apple,
        std::to_array<Outline>({{0, 0.062}, {0.006, 0.064}, {0.016, 0.070}, {0.026, 0.069},
            {0.034, 0.060}, {0.038, 0.046}, {0.037, 0.030}, {0.031, 0.014}, {0.022, 0.004},
            {0.012, 0.001}, {0.005, 0.004}, {0, 0.005}}),
        24);
    const std::uint32_t apple_mesh = room.add_mesh(std::move(apple));
    Shape stalk;
    add_tube(stalk,
        std::to_array<TubePoint>({{{0, 0.058, 0}, 0.0012}, {{0.002, 0.072, 0}, 0.0013},
            {{0.006, 0.082, 0.001}, 0.0017}}),
        {.sides = 6, .across = {0, 0, 1}});
    const std::uint32_t stalk_mesh = room.add_mesh(std::move(stalk));
    Shape orange;
    add_ellipsoid(orange, {0.036, 0.034, 0.036}, 20);
    const std::uint32_t orange_mesh = room.add_mesh(std::move(orange));

    const RoomMaterials& m = room.materials();
    struct FruitPlace {
        double x, y, z, lean;
        bool apple;
    };
    constexpr std::array<FruitPlace, 7> kPlaces{{{-0.050, 0.028, 0.030, 0.3, true},
        {0.046, 0.066, 0.040, 0, false}, {0.008, 0.030, -0.055, -0.25, true},
        {-0.052, 0.074, -0.045, 0, false}, {0.056, 0.034, -0.028, 0.4, true},
        {0.000, 0.074, 0.000, -0.35, true}, {-0.010, 0.068, 0.074, 0, false}}};
    for (const FruitPlace& at : kPlaces) {
        const std::int32_t here = room.add_node(
            at.apple ? "apple" : "orange", node, moved(at.x, at.y, at.z, {0.6, 0, 0.8}, at.lean));
        room.place(at.apple ? apple_mesh : orange_mesh, here, at.apple ? m.apple : m.orange);
        if (at.apple) room.place(stalk_mesh, here, m.bark);
    }
}

} // namespace

void add_crockery(RoomScene& room)
{
    const std::int32_t table =
        room.add_node("on the table", -1, moved(kTablePlace.x, kTableTop, kTablePlace.z));
    add_kettle(room, table);
    add_cups(room, table);
    add_glass(room, table);
    add_fruit(room, table);
}

} // namespace firsthit
