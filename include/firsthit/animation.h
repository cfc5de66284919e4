// animation.h - how nodes move: channels of keys, gathered in clips.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace firsthit {

/// parent_from_node = translation * rotation * scale.
struct NodeTransform {
    glm::dvec3 translation{0};       // in units of the parent
    glm::dquat rotation{1, 0, 0, 0}; // unit quaternion, w first
    glm::dvec3 scale{1};             // a factor on each axis of the node; may be negative
};

/// One key of a Kochanek-Bartels spline. value: a translation or scale in xyz, or a unit quaternion
/// with xyz the vector part and w the scalar part.
struct TcbKey {
    double time_s = 0;            // when
    glm::dvec4 value{0, 0, 0, 1}; // a vector, or a quaternion (x, y, z, w)
    double tension = 0;           // -1 to 1; 0: a Catmull-Rom spline
    double continuity = 0;        // -1 to 1
    double bias = 0;              // -1 to 1
};

/// What moves one property of one node. Before the first and after the last key the property stays
/// as at that key; of `tcb`, whose outer keys only shape the end tangents, as at the second key and
/// the last but one (see src/scene/animate/tcb_spline.h).
struct Channel {
    /// The property, and how many numbers C its values have.
    enum class Path {
        translation, // C = 3
        rotation,    // C = 4: a quaternion (x, y, z, w), normalised before it is used
        scale,       // C = 3
        weights,     // C = number of morph targets of the meshes at the node
        visibility,  // C = 1: 0 hides the node and its children, all else shows them
    };
    /// How values between two keys are found.
    enum class Interpolation {
        step,   // the earlier key's value
        linear, // between the two; of rotations on the great arc, the short way
        cubic,  // a Hermite spline; of rotations by components, then normalised
        tcb,    // a Kochanek-Bartels spline through `tcb`: translation, rotation, scale
    };
    std::uint32_t node = 0;                              // of Scene::nodes
    Path path = Path::translation;                       // what it moves
    Interpolation interpolation = Interpolation::linear; // between keys

    std::vector<double> time_s{}; // (K) increasing; unused by tcb
    /// (K, C); of cubic (K, 3, C): tangent before the key, value, tangent after it, the tangents in
    /// units of the value a second. Unused by tcb.
    std::vector<double> value{};
    std::vector<TcbKey> tcb{}; // of tcb: in order of time
};

/// A named animation. A node that no channel of the clip moves stays as it is at rest.
struct Clip {
    std::string name{};              // as the file has it
    double begin_s = 0;              // where it starts
    double end_s = 0;                // where it ends, not before begin_s
    int frames = 1;                  // that the file asks for, from begin_s to end_s
    std::vector<Channel> channels{}; // at most one for a path of a node
};

} // namespace firsthit
