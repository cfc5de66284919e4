// walk.h - how a robot walks: tracks for its joints.
#pragma once

#include "scene/animate/track.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>

#include <functional>
#include <string>

namespace firsthit {

/// Where the joints are, in the robot's frame: z is forward, x to its left, y up, metres.
struct RobotSize {
    double thigh = 0.46;           // hip to knee
    double shin = 0.44;            // knee to ankle
    double ankle = 0.10;           // above the sole
    double hip_height = 0.915;     // of the hips above the ground, in the middle of its bobbing
    double hip_width = 0.13;       // from the middle
    double waist = 0.10;           // of the torso's joint over the hips
    double shoulder_height = 0.44; // over the waist
    double shoulder_width = 0.335;
    double neck = 0.57; // over the waist
    double upper_arm = 0.31;
};

/// A robot's way: around a circle, at constant speed.
struct Walk {
    glm::dvec2 center{0}; // x, z
    double radius = 3;    // m
    double start_rad = 0; // where on the circle at time 0
    double direction = 1; // 1 counter-clockwise seen from above, -1 clockwise
    double speed = 0.9;   // m/s in the robot's own size
    double size = 1;      // of the robot, 1: 2 m
    double step_s = 1.1;  // for two steps
    double phase = 0;     // of the steps, 0 to 1
    bool waves = false;   // with the right hand
};

enum class Side { left, right };

/// The tracks cover begin_s to end_s. Feet on the ground move back as fast as the robot moves on.
struct WalkTracks {
    Track root; // moves in the world
    Track hips;
    Track torso;
    Track head;
    Track thigh[2]; // by Side
    Track shin[2];
    Track foot[2];
    Track upper_arm[2];
    Track forearm[2];
};
WalkTracks make_walk(const std::string& name, const Walk& walk, const RobotSize& robot,
    double begin_s, double end_s);

/// Position and turn of a frame in its parent.
struct Placement {
    glm::dvec3 position{0};
    glm::dquat turn{1, 0, 0, 0};
};

/// Samples a movement into keys `step_s` apart, with one more key at both ends, which only shape
/// the tangents there.
Track sample_track(std::string name, double begin_s, double end_s, double step_s,
    const std::function<Placement(double time_s)>& movement);

} // namespace firsthit
