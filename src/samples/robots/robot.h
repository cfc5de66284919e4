// robot.h - one robot: its body, hung on its joints.
#pragma once

#include "samples/robots/robot_scene.h"
#include "samples/robots/walk.h"

#include <cstdint>
#include <string>

namespace firsthit {

/// Materials of the scene that a robot wears.
struct RobotPaint {
    std::uint32_t body = 0;
    std::uint32_t metal = 0;
    std::uint32_t rubber = 0;
    std::uint32_t glow = 0;
};

/// Adds a robot of about 7,000 triangles that walks.
void add_robot(RobotScene& scene, const std::string& name, const RobotPaint& paint,
    const Walk& walk, double begin_s, double end_s);

} // namespace firsthit
