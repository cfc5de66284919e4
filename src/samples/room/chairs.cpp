// chairs.cpp - chairs with spindles in their backs.
#include "samples/room/furniture.h"
#include "samples/room/swept.h"

#include <array>
#include <utility>

namespace firsthit {
namespace {

constexpr double kSeat = 0.45; // m above the floor

/// A rod that is thickest in its middle.
void add_spindle(
    Shape& shape, const glm::dvec3& from, const glm::dvec3& to, double radius, int sides)
{
    std::vector<TubePoint> path;
    constexpr int kSteps = 6;
    for (int k = 0; k <= kSteps; ++k) {
        const double u = static_cast<double>(k) / kSteps;
        path.push_back({from + u * (to - from), radius * (0.6 + 1.6 * u * (1 - u))});
    }
    add_tube(shape, path, {.sides = sides, .across = {1, 0, 0}});
}

/// Of a chair that looks along -z, with its middle over the origin.
Shape chair_frame()
{
    Shape chair;
    add_rounded_box(chair, {0.205, 0.014, 0.200}, 0.012, 3, moved(0, kSeat - 0.014, 0));
    for (const double side : {-1.0, 1.0}) {
        // A front leg; a back leg that goes on as the back's post.
        add_spindle(
            chair, {side * 0.195, 0.012, -0.195}, {side * 0.170, kSeat - 0.02, -0.165}, 0.019, 10);
        add_tube(chair,
            std::to_array<TubePoint>(
                {{{side * 0.190, 0.012, 0.225}, 0.013}, {{side * 0.180, 0.22, 0.190}, 0.017},
                    {{side * 0.175, kSeat, 0.180}, 0.018}, {{side * 0.178, 0.66, 0.195}, 0.016},
                    {{side * 0.186, 0.88, 0.240}, 0.014}, {{side * 0.188, 0.925, 0.252}, 0.012}}),
            {.sides = 10, .across = {1, 0, 0}});
        // Stretchers.
        add_rod(chair, {side * 0.187, 0.17, -0.186}, {side * 0.183, 0.20, 0.193}, 0.009, 10);
    }
    add_rod(chair, {-0.186, 0.19, 0.0}, {0.186, 0.19, 0.0}, 0.009, 10);
    add_rod(chair, {-0.183, 0.27, 0.187}, {0.183, 0.27, 0.187}, 0.009, 10);
    add_rounded_box(chair, {0.215, 0.034, 0.011}, 0.009, 3, moved(0, 0.90, 0.246, {1, 0, 0}, 0.2));
    for (int k = 0; k < 6; ++k) {
        const double x = 0.135 * (2 * k / 5.0 - 1);
        add_spindle(chair, {0.92 * x, kSeat - 0.01, 0.175}, {x, 0.88, 0.243}, 0.010, 7);
    }
    return chair;
}

} // namespace

void add_chairs(RoomScene& room)
{
    Shape frame = chair_frame();
    std::vector<glm::vec2> uv = box_mapping(frame, 1.0);
    const std::uint32_t wood = room.add_mesh(std::move(frame), std::move(uv));
    Shape seat;
    add_rounded_box(seat, {0.180, 0.020, 0.175}, 0.019, 5, moved(0, kSeat + 0.021, -0.005));
    uv = box_mapping(seat, 0.2);
    const std::uint32_t cloth = room.add_mesh(std::move(seat), std::move(uv));

    struct ChairPlace {
        double x, z, turn;
    };
    // The last one has been pushed back and turned by who got up.
    constexpr std::array<ChairPlace, 4> kPlaces{
        {{-0.38, 0.50, 0.06}, {0.38, -0.52, 3.10}, {-0.36, -0.55, 3.22}, {0.50, 0.62, 0.42}}};
    for (const ChairPlace& at : kPlaces) {
        const std::int32_t node = room.add_node("chair", -1,
            moved(kTablePlace.x + at.x, 0.012, kTablePlace.z + at.z, {0, 1, 0}, at.turn));
        room.place(wood, node, room.materials().walnut);
        room.place(cloth, node, room.materials().cushion);
    }
}

} // namespace firsthit
