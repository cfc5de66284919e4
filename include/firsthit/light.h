// light.h - what lights a scene.
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <string>

namespace firsthit {

/// A light. Only one with `inverse_square` fades with distance.
struct Light {
    /// Where its light comes from.
    enum class Kind {
        point,       // from a position to all sides
        spot,        // from a position into a cone
        directional, // parallel, from infinitely far away
    };
    Kind kind = Kind::point;        // which members count
    glm::dvec3 position{0};         // point, spot; in the space of `node`
    glm::dvec3 direction{0, -1, 0}; // spot, directional: the way the light goes, of any length;
                                    // in the space of `node`
    double inner_rad = 0; // spot: half angle of the cone that has the full light, 0 to outer
    double outer_rad = 0.78539816339744831; // spot: half angle where it ends, in (0, pi / 2);
                                            // between the two it fades as smoothstep of the cosine,
                                            // that of an inverse_square light as the square
    glm::vec3 color{1.0f};                  // linear Rec.709, may exceed 1
    bool inverse_square =
        false;              // point, spot: color is the light at a distance of 1, and fades with
                            // the square of the distance
    double range = 0;       // where an inverse_square light has faded to nothing; 0: nowhere
    std::int32_t node = -1; // of Scene::nodes, moves and turns it; -1: the world
    bool on_camera =
        false;          // it goes with the camera, whatever `node` is: position and direction are
                        // in the camera's space (x right, y up, z towards the viewer); see
                        // hang_lights in world.h
    std::string name{}; // as the file has it
};

} // namespace firsthit
