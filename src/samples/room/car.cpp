// car.cpp - the toy car, and its drive around the table.
#include "samples/room/furniture.h"
#include "samples/room/swept.h"
#include "samples/trigonometry.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace firsthit {
namespace {

constexpr double kWheelRadius = 0.034, kAxle = 0.085, kTrack = 0.062; // m
constexpr double kWayX = 1.95, kWayZ = 1.42; // m, half axes of the ellipse it drives on
constexpr double kStart = 1.62;              // rad, where on the ellipse it starts
constexpr double kTurn = 2 * std::numbers::pi / kRoomEnd; // rad/s of the ellipse's parameter

/// Where the car is on its way, and how it stands there.
struct Drive {
    glm::dvec3 place{0}, forward{0};
    double speed = 0;     // m/s
    double curvature = 0; // 1/m, positive to its left
};

Drive drive_at(double time_s)
{
    const auto [s, c] = sine_cosine(kStart + kTurn * time_s);
    Drive drive;
    drive.place = {kTablePlace.x + kWayX * c, 0, kTablePlace.z + kWayZ * s};
    const glm::dvec3 velocity(-kWayX * s * kTurn, 0, kWayZ * c * kTurn);
    drive.speed = glm::length(velocity);
    drive.forward = velocity / drive.speed;
    const double ratio = drive.speed / std::abs(kTurn);
    drive.curvature = (kTurn < 0 ? 1 : -1) * kWayX * kWayZ / (ratio * ratio * ratio);
    return drive;
}

/// The way from the start, by Simpson's rule over small steps.
double distance_at(double time_s)
{
    constexpr int kSteps = 32; // a second
    const auto count = static_cast<int>(time_s * kSteps + 0.999999);
    if (count == 0) return 0;
    const double step = time_s / count;
    double sum = 0;
    for (int k = 0; k < count; ++k)
        sum += drive_at(k * step).speed + 4 * drive_at((k + 0.5) * step).speed +
               drive_at((k + 1) * step).speed;
    return sum * step / 6;
}

Shape wheel_shape()
{
    // Its axis is z, made around y.
    Shape tyre;
    const glm::dmat4 to_axle = moved(0, 0, 0, {1, 0, 0}, std::numbers::pi / 2);
    add_lathe(tyre,
        std::to_array<Outline>({{0.021, 0.012}, {0.029, 0.013}, {0.033, 0.009},
            {kWheelRadius, 0.004}, {kWheelRadius, -0.004}, {0.033, -0.009}, {0.029, -0.013},
            {0.021, -0.012}, {0.021, -0.012}, {0.021, 0.012}}),
        28, to_axle);
    return tyre;
}

Shape hub_shape()
{
    Shape hub;
    const glm::dmat4 to_axle = moved(0, 0, 0, {1, 0, 0}, std::numbers::pi / 2);
    add_lathe(hub,
        std::to_array<Outline>({{0.0215, 0.010}, {0.0215, -0.010}, {0.0215, -0.010},
            {0.0175, -0.010}, {0.0175, -0.010}, {0.0175, 0.010}, {0.0175, 0.010}, {0.0215, 0.010}}),
        20, to_axle);
    add_lathe(hub,
        std::to_array<Outline>({{0, 0.011}, {0.004, 0.010}, {0.006, 0.006}, {0.006, -0.006},
            {0.004, -0.010}, {0, -0.011}}),
        10, to_axle);
    for (int spoke = 0; spoke < 6; ++spoke) {
        const auto [s, c] = sine_cosine(std::numbers::pi / 3 * spoke);
        add_tube(hub,
            std::to_array<TubePoint>(
                {{{0.005 * c, 0.005 * s, 0}, 0.0022}, {{0.0185 * c, 0.0185 * s, 0}, 0.0018}}),
            {.sides = 5, .across = {0, 0, 1}});
    }
    return hub;
}

void add_body(RoomScene& room, std::int32_t car)
{
    const RoomMaterials& m = room.materials();
    // It looks along x.
    Shape body;
    add_rounded_box(body, {0.145, 0.020, 0.052}, 0.018, 4, moved(0, 0.048, 0));
    add_rounded_box(body, {0.060, 0.020, 0.044}, 0.017, 4, moved(0.078, 0.076, 0));
    add_rounded_box(body, {0.038, 0.018, 0.046}, 0.016, 4, moved(-0.100, 0.074, 0));
    for (const double x : {-kAxle, kAxle})
        for (const double side : {-1.0, 1.0}) {
            const std::vector<TubePoint> arch = sample_path(14, 0.0055, [&](double u) {
                const auto [s, c] = sine_cosine(std::numbers::pi * (0.04 + 0.92 * u));
                return glm::dvec3(x + 0.042 * c, kWheelRadius + 0.042 * s, side * (kTrack - 0.004));
            });
            add_tube(body, arch, {.sides = 10, .across = {0, 0, 1}});
        }
    room.add(car, m.car_red, std::move(body));

    // A roof on four pillars: one can look through.
    Shape roof;
    add_rounded_box(roof, {0.058, 0.007, 0.044}, 0.006, 4, moved(-0.022, 0.134, 0));
    for (const double side : {-1.0, 1.0}) {
        add_rod(roof, {0.052, 0.086, side * 0.038}, {0.028, 0.132, side * 0.037}, 0.0035, 8);
        add_rod(roof, {-0.074, 0.082, side * 0.040}, {-0.070, 0.132, side * 0.037}, 0.0045, 8);
    }
    add_rounded_box(roof, {0.022, 0.014, 0.036}, 0.010, 4, moved(-0.030, 0.074, 0));
    add_rounded_box(roof, {0.008, 0.026, 0.036}, 0.007, 4, moved(-0.056, 0.090, 0));
    room.add(car, m.car_cream, std::move(roof));

    Shape metal;
    for (const double x : {-0.150, 0.150})
        add_tube(metal,
            std::to_array<TubePoint>({{{0.94 * x, 0.040, -0.050}, 0.005},
                {{x, 0.040, -0.036}, 0.005}, {{1.02 * x, 0.040, 0}, 0.005},
                {{x, 0.040, 0.036}, 0.005}, {{0.94 * x, 0.040, 0.050}, 0.005}}),
            {.sides = 10});
    for (const double x : {-kAxle, kAxle})
        add_rod(metal, {x, kWheelRadius, -kTrack}, {x, kWheelRadius, kTrack}, 0.003, 8);
    for (int bar = 0; bar < 5; ++bar)
        add_rod(
            metal, {0.139, 0.064, 0.008 * (bar - 2)}, {0.139, 0.088, 0.008 * (bar - 2)}, 0.0016, 6);
    // The steering wheel.
    std::vector<TubePoint> wheel;
    for (int k = 0; k < 20; ++k) {
        const auto [s, c] = sine_cosine(2 * std::numbers::pi * k / 20);
        wheel.push_back({{0.014 - 0.005 * c, 0.099 + 0.010 * c, 0.014 + 0.011 * s}, 0.0014});
    }
    add_tube(metal, wheel, {.sides = 6, .across = {0.9, 0.44, 0}, .ring = true});
    room.add(car, m.chrome, std::move(metal));

    Shape lamps;
    for (const double side : {-1.0, 1.0})
        add_ellipsoid(lamps, {0.007, 0.011, 0.011}, 18, moved(0.134, 0.076, side * 0.030));
    room.add(car, m.headlight, std::move(lamps));
}

NodeTransform car_at(double time_s)
{
    const Drive drive = drive_at(time_s);
    const glm::dvec3 up(0, 1, 0);
    NodeTransform at;
    at.translation = drive.place;
    at.rotation = glm::quat_cast(glm::dmat3(drive.forward, up, glm::cross(drive.forward, up)));
    return at;
}

} // namespace

void add_car(RoomScene& room)
{
    const std::int32_t car = room.add_moving_node("car", -1, 0.25, car_at);
    add_body(room, room.add_node("body", car, glm::dmat4(1)));
    const std::uint32_t tyre = room.add_mesh(wheel_shape());
    const std::uint32_t hub = room.add_mesh(hub_shape());

    for (const double x : {-kAxle, kAxle})
        for (const double side : {-1.0, 1.0}) {
            const std::int32_t node = room.add_moving_node("wheel", car, 0.05, [&](double time_s) {
                // A wheel rolls as far as the car drives; the front ones are turned into the bend, by
                // about as much as the car turns over its length.
                const Drive drive = drive_at(time_s);
                const double steer = x > 0 ? 2 * kAxle * drive.curvature : 0;
                NodeTransform at;
                at.translation = {x, kWheelRadius, side * kTrack};
                at.rotation = turn_about({0, 1, 0}, steer) *
                              turn_about({0, 0, 1}, -distance_at(time_s) / kWheelRadius);
                return at;
            });
            room.place(tyre, node, room.materials().rubber);
            room.place(hub, node, room.materials().chrome);
        }
}

} // namespace firsthit
