// baskets.cpp - baskets, woven strand by strand.
#include "samples/room/furniture.h"
#include "samples/room/swept.h"
#include "samples/trigonometry.h"

#include <array>
#include <numbers>
#include <utility>

namespace firsthit {
namespace {

constexpr int kStakes = 22; // even: the strands go before one and behind the next
constexpr int kRows = 10;   // strands around
constexpr double kHeight = 0.16;

/// The radius of the wall at a height.
double wall_at(double y)
{
    const double u = y / kHeight;
    return 0.105 + 0.060 * u - 0.025 * u * u;
}

glm::dvec3 around_basket(double turn, double radius, double y)
{
    const auto [s, c] = sine_cosine(2 * std::numbers::pi * turn);
    return {radius * c, y, radius * s};
}

Shape basket_shape()
{
    Shape basket;
    add_lathe(basket,
        std::to_array<Outline>(
            {{0, 0.012}, {0.108, 0.012}, {0.110, 0.008}, {0.108, 0.004}, {0, 0.004}}),
        44);
    for (int stake = 0; stake < kStakes; ++stake) {
        std::vector<TubePoint> path;
        for (int k = 0; k <= 4; ++k) {
            const double y = 0.006 + (kHeight - 0.006) * k / 4;
            path.push_back(
                {around_basket(static_cast<double>(stake) / kStakes, wall_at(y), y), 0.0030});
        }
        add_tube(basket, path, {.sides = 5, .across = {1, 0, 0.01}});
    }
    constexpr int kPoints = kStakes * 3;
    for (int row = 0; row < kRows; ++row) {
        const double y = 0.014 + (kHeight - 0.020) * row / (kRows - 1);
        std::vector<TubePoint> strand;
        for (int k = 0; k < kPoints; ++k) {
            const double turn = static_cast<double>(k) / kPoints;
            const double wave =
                cosine(std::numbers::pi * (kStakes * turn + row)); // 1 before a stake, -1 behind
            strand.push_back({around_basket(turn, wall_at(y) + 0.0062 * wave, y), 0.0038});
        }
        add_tube(basket, strand, {.sides = 4, .ring = true});
    }
    // The rim: two strands twisted around each other.
    for (const double half : {0.0, 0.5}) {
        std::vector<TubePoint> strand;
        for (int k = 0; k < 80; ++k) {
            const double turn = k / 80.0;
            const auto [s, c] = sine_cosine(2 * std::numbers::pi * (12 * turn + half));
            strand.push_back(
                {around_basket(turn, wall_at(kHeight) + 0.0055 * c, kHeight + 0.002 + 0.0055 * s),
                    0.0055});
        }
        add_tube(basket, strand, {.sides = 5, .ring = true});
    }
    // The handle.
    for (const double half : {0.0, 0.5}) {
        const std::vector<TubePoint> path = sample_path(40, 0.0050, [&](double u) {
            const auto [s, c] = sine_cosine(std::numbers::pi * u);
            const auto [twist_s, twist_c] = sine_cosine(2 * std::numbers::pi * (7 * u + half));
            const double reach = wall_at(kHeight) - 0.004 + 0.0045 * twist_c;
            return glm::dvec3(reach * c, kHeight - 0.02 + 1.05 * reach * s, 0.0045 * twist_s);
        });
        add_tube(basket, path, {.sides = 6, .across = {0, 0, 1}});
    }
    return basket;
}

/// Rolls of bread in the basket on the table.
void add_rolls(RoomScene& room, std::int32_t node)
{
    Shape roll;
    add_ellipsoid(roll, {0.052, 0.030, 0.036}, 18);
    const std::uint32_t mesh = room.add_mesh(std::move(roll));
    struct RollPlace {
        double x, y, z, turn;
    };
    constexpr std::array<RollPlace, 6> kPlaces{{{-0.055, 0.060, 0.020, 0.4},
        {0.050, 0.060, 0.035, 2.0}, {0.005, 0.062, -0.060, 1.1}, {-0.020, 0.108, 0.035, 2.6},
        {0.040, 0.110, -0.030, 0.9}, {-0.055, 0.106, -0.040, 1.9}}};
    for (const RollPlace& at : kPlaces)
        room.place(mesh, room.add_node("roll", node, moved(at.x, at.y, at.z, {0, 1, 0}, at.turn)),
            room.materials().oak);
}

} // namespace

void add_baskets(RoomScene& room)
{
    const std::uint32_t mesh = room.add_mesh(basket_shape());
    const std::int32_t on_table = room.add_node("bread basket", -1,
        moved(kTablePlace.x - 0.48, kTableTop, kTablePlace.z + 0.02, {0, 1, 0}, 0.9));
    room.place(mesh, on_table, room.materials().wicker);
    add_rolls(room, on_table);

    glm::dmat4 large = moved(1.55, 0.0, -1.55, {0, 1, 0}, 0.4);
    for (int axis = 0; axis < 3; ++axis) large[axis] *= 1.5;
    room.place(mesh, room.add_node("floor basket", -1, large), room.materials().wicker);
}

} // namespace firsthit
