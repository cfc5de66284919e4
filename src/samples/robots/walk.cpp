// walk.cpp - how a robot walks: tracks for its joints.
#include "samples/robots/walk.h"

#include "samples/robots/axes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace firsthit {
namespace {

constexpr double kStance = 0.6;      // part of a cycle that a foot is on the ground
constexpr double kLift = 0.11;       // m, of a foot in the air
constexpr double kBob = 0.018;       // m, of the hips
constexpr double kKeysPerCycle = 16; // keeps the feet within millimetres between keys

double fraction(double x)
{
    return x - std::floor(x);
}

/// An ankle, seen from the hip's ground point.
struct Ankle {
    double forward = 0;
    double height = 0;
    double toe_down = 0; // pitch of the foot, radians
};

Ankle ankle_at(double phase, double reach, double ankle_height)
{
    Ankle ankle;
    if (phase < kStance) {
        // On the ground: from the front to the back at constant speed.
        ankle.forward = reach * (1 - 2 * phase / kStance);
        ankle.height = ankle_height;
        return ankle;
    }
    // In the air: a cubic that starts and ends at the ground's speed.
    const double u = (phase - kStance) / (1 - kStance);
    const double slope = -2 * reach / kStance * (1 - kStance);
    const double u2 = u * u;
    const double u3 = u2 * u;
    ankle.forward = -reach * (2 * u3 - 3 * u2 + 1) + reach * (3 * u2 - 2 * u3) +
                    slope * (u3 - 2 * u2 + u) + slope * (u3 - u2);
    const double arc = std::sin(std::numbers::pi * u);
    ankle.height = ankle_height + kLift * arc * arc;
    ankle.toe_down = 0.5 * std::sin(2 * std::numbers::pi * u) * arc;
    return ankle;
}

struct LegAngles {
    double hip = 0;  // thigh forward
    double knee = 0; // shin back, from straight
    double foot = 0; // turn of the foot about x
};

/// Two-bone inverse kinematics by the law of cosines; the knee points forward.
LegAngles bend_leg(const Ankle& ankle, double hip_height, const RobotSize& robot)
{
    const double down = hip_height - ankle.height;
    const double a = robot.thigh;
    const double b = robot.shin;
    const double distance = std::min(std::hypot(ankle.forward, down), 0.9995 * (a + b));
    const double inside_knee = std::acos((a * a + b * b - distance * distance) / (2 * a * b));
    const double before_thigh =
        std::acos((a * a + distance * distance - b * b) / (2 * a * distance));
    LegAngles angles;
    angles.hip = std::atan2(ankle.forward, down) + before_thigh;
    angles.knee = std::numbers::pi - inside_knee;
    angles.foot = ankle.toe_down + angles.hip - angles.knee;
    return angles;
}

TcbKey key_at(double time_s, const glm::dvec4& value)
{
    TcbKey key;
    key.time_s = time_s;
    key.value = value;
    return key;
}

/// One robot's movement as functions of time.
class Walker {
  public:
    Walker(const Walk& walk, const RobotSize& robot) : walk_(walk), robot_(robot) {}

    Placement root(double t) const
    {
        const double speed = walk_.speed * walk_.size;
        const double angle = walk_.start_rad + walk_.direction * speed / walk_.radius * t;
        Placement placed;
        placed.position = {walk_.center.x + walk_.radius * std::cos(angle), 0,
            walk_.center.y - walk_.radius * std::sin(angle)};
        // Looks along the circle.
        placed.turn = glm::angleAxis(angle + (walk_.direction > 0 ? std::numbers::pi : 0.0), kY);
        return placed;
    }

    Placement hips(double t) const { return {{0, hip_height(t), 0}, {1, 0, 0, 0}}; }

    Placement torso(double t) const
    {
        const double turn = 2 * std::numbers::pi * phase(t);
        return {{0, robot_.waist, 0}, glm::angleAxis(0.10 * std::cos(turn), kY) *
                                          glm::angleAxis(0.035 * std::sin(turn), kZ) *
                                          glm::angleAxis(0.05, kX)};
    }

    Placement head(double t) const
    {
        const double look = 0.45 * std::sin(2 * std::numbers::pi * (t / 5.0 + walk_.phase));
        const double nod = 0.06 * std::sin(4 * std::numbers::pi * phase(t));
        return {{0, robot_.neck, 0}, glm::angleAxis(look, kY) * glm::angleAxis(nod, kX)};
    }

    Placement thigh(double t, Side side) const
    {
        return {{sign(side) * robot_.hip_width, 0, 0}, glm::angleAxis(-leg(t, side).hip, kX)};
    }
    Placement shin(double t, Side side) const
    {
        return {{0, -robot_.thigh, 0}, glm::angleAxis(leg(t, side).knee, kX)};
    }
    Placement foot(double t, Side side) const
    {
        return {{0, -robot_.shin, 0}, glm::angleAxis(leg(t, side).foot, kX)};
    }

    Placement upper_arm(double t, Side side) const
    {
        const glm::dvec3 shoulder(sign(side) * robot_.shoulder_width, robot_.shoulder_height, 0);
        if (waves(side)) return {shoulder, glm::angleAxis(sign(side) * 2.35, kZ)};
        return {shoulder, glm::angleAxis(sign(side) * 0.13, kZ) *
                              glm::angleAxis(-0.5 * arm_forward(t, side), kX)};
    }
    Placement forearm(double t, Side side) const
    {
        const glm::dvec3 elbow(0, -robot_.upper_arm, 0);
        if (waves(side))
            return {elbow, glm::angleAxis(sign(side) * (0.45 + 0.45 * std::sin(7.5 * t)), kZ)};
        return {elbow, glm::angleAxis(-0.55 - 0.25 * arm_forward(t, side), kX)};
    }

  private:
    static double sign(Side side) { return side == Side::left ? 1.0 : -1.0; }
    bool waves(Side side) const { return walk_.waves && side == Side::right; }
    /// Of the left leg, 0 to 1 from touching the ground on.
    double phase(double t) const { return fraction(t / walk_.step_s + walk_.phase); }

    double hip_height(double t) const
    {
        // Highest while one leg passes the other.
        return robot_.hip_height + kBob * std::cos(4 * std::numbers::pi * (phase(t) - kStance / 2));
    }

    LegAngles leg(double t, Side side) const
    {
        const double own = fraction(phase(t) + (side == Side::left ? 0.0 : 0.5));
        const double reach = walk_.speed * walk_.step_s * kStance / 2;
        return bend_leg(ankle_at(own, reach, robot_.ankle), hip_height(t), robot_);
    }

    /// Arms go with the other side's leg.
    double arm_forward(double t, Side side) const
    {
        return -sign(side) * std::cos(2 * std::numbers::pi * phase(t));
    }

    const Walk& walk_;
    const RobotSize& robot_;
};

} // namespace

Track sample_track(std::string name, double begin_s, double end_s, double step_s,
    const std::function<Placement(double time_s)>& movement)
{
    Track track;
    track.name = std::move(name);
    const auto last = static_cast<int>(std::ceil((end_s - begin_s) / step_s)) + 1;
    for (int k = -1; k <= last; ++k) {
        const double t = begin_s + k * step_s;
        const Placement placed = movement(t);
        track.translation.push_back(key_at(t, glm::dvec4(placed.position, 0)));

        // Of the two quaternions of a turn, the one nearer to the last key's.
        const glm::dquat& q = placed.turn;
        glm::dvec4 value(q.x, q.y, q.z, q.w);
        if (!track.rotation.empty()) {
            const glm::dvec4& before = track.rotation.back().value;
            const double dot =
                before.x * value.x + before.y * value.y + before.z * value.z + before.w * value.w;
            if (dot < 0) value = -value;
        }
        track.rotation.push_back(key_at(t, value));
    }
    return track;
}

WalkTracks make_walk(
    const std::string& name, const Walk& walk, const RobotSize& robot, double begin_s, double end_s)
{
    const Walker walker(walk, robot);
    const double step_s = walk.step_s / kKeysPerCycle;
    const auto sample = [&](const char* joint, const std::function<Placement(double)>& movement) {
        return sample_track(name + " " + joint, begin_s, end_s, step_s, movement);
    };
    WalkTracks tracks;
    tracks.root = sample("way", [&](double t) { return walker.root(t); });
    tracks.hips = sample("hips", [&](double t) { return walker.hips(t); });
    tracks.torso = sample("torso", [&](double t) { return walker.torso(t); });
    tracks.head = sample("head", [&](double t) { return walker.head(t); });
    for (const Side side : {Side::left, Side::right}) {
        const auto s = static_cast<std::size_t>(side);
        tracks.thigh[s] = sample("thigh", [&](double t) { return walker.thigh(t, side); });
        tracks.shin[s] = sample("shin", [&](double t) { return walker.shin(t, side); });
        tracks.foot[s] = sample("foot", [&](double t) { return walker.foot(t, side); });
        tracks.upper_arm[s] =
            sample("upper arm", [&](double t) { return walker.upper_arm(t, side); });
        tracks.forearm[s] = sample("forearm", [&](double t) { return walker.forearm(t, side); });
    }
    return tracks;
}

} // namespace firsthit
