// mesh.h - vertices and triangles in object space, and what changes their shape.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace firsthit {

/// A mesh's shape at one time: the shape between two keys is interpolated linearly, clamped outside.
struct MorphKey {
    double time_s = 0;               // when
    std::vector<glm::vec3> position; // (V) object space
    std::vector<glm::vec3> normal;   // (V) unit, object space
};

/// Writes the object-space positions and unit normals of a mesh's vertices [first, last) at a
/// time. position[0] and normal[0] are vertex `first`. Called from several threads for disjoint
/// ranges.
using Deform = std::function<void(
    double time_s, std::size_t first, std::size_t last, glm::vec3* position, glm::vec3* normal)>;

/// A displacement of vertices that is added with a weight.
struct MorphTarget {
    std::string name{};                // as the file has it
    std::vector<glm::vec3> position{}; // (V) what is added to positions; empty: nothing
    std::vector<glm::vec3> normal{};   // (V) what is added to normals; empty: nothing
    std::vector<glm::vec3> tangent{};  // (V) what is added to tangents; empty: nothing
};

/// How vertices follow the joints of a skin.
struct SkinWeights {
    int influences = 0;               // joints of a vertex, 0: not skinned
    std::vector<std::uint16_t> joint; // (V, influences) of Skin::joints
    std::vector<float> weight;        // (V, influences); of a vertex their sum is 1
};

/// What the instances of a mesh share besides arrays that are kept for each instance.
struct MeshShape {
    std::string name;                 // as the file has it
    std::vector<MorphTarget> targets; // morph targets, in the order of their weights
    std::vector<float> weights;       // (targets) at rest; empty: 0
    SkinWeights skin;                 // how it follows a skin
};

/// A mesh as SceneBuilder takes it. V vertices, T triangles.
struct Mesh {
    MeshShape shape;                 // its name, morph targets and skin weights
    std::vector<glm::vec3> position; // (V) object space
    std::vector<glm::vec3>
        normal;                 // (V) unit; or empty: flat, and always those of the posed triangles
    std::vector<glm::vec2> uv;  // (V) texture coordinates; or empty: 0
    std::vector<glm::vec2> uv1; // (V) a second set; or empty: 0
    std::vector<glm::vec4> color; // (V) linear red, green, blue, and alpha; or empty: 1
    std::vector<glm::vec4>
        tangent; // (V) unit in xyz, w = 1 or -1: bitangent = w * cross(n, t); or empty
    std::vector<glm::uvec3> index; // (T) into position, counter-clockwise = front
    std::vector<MorphKey> keys;    // shapes at times; empty: none
    Deform deform;                 // set: writes the vertices; position and normal may be empty
    std::size_t vertices = 0;      // V where position is empty
};

/// Joints that move the vertices of a mesh.
struct Skin {
    std::string name;                     // as the file has it
    std::vector<std::uint32_t> joints;    // of Scene::nodes
    std::vector<glm::dmat4> inverse_bind; // (joints) joint_from_object in the pose of binding
};

} // namespace firsthit
