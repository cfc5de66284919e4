// scene.h - a scene as it was read, and the world it makes at one time.
#pragma once

#include <firsthit/material.h>
#include <firsthit/texture.h>
#include <firsthit/view.h>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace firsthit {

/// No triangle. The value of an item where a ray meets nothing.
inline constexpr std::uint32_t kNoItem = 0xFFFFFFFFu;

/// One key of a Kochanek-Bartels spline. value: a translation or scale in xyz, or a unit quaternion
/// with xyz the vector part and w the scalar part.
struct TrackKey {
    double time_s = 0;            // when
    glm::dvec4 value{0, 0, 0, 1}; // a vector, or a quaternion (x, y, z, w)
    double tension = 0;           // -1 to 1; 0: a Catmull-Rom spline
    double continuity = 0;        // -1 to 1
    double bias = 0;              // -1 to 1
};

/// The movement of a node: matrix = T * R * S, a missing part is the identity. As in BART, the
/// first and the last key of a part only shape the end tangents (see src/scene/track.h).
struct Track {
    std::string name;                  // as the file has it
    std::vector<TrackKey> translation; // in order of time
    std::vector<TrackKey> rotation;    // in order of time
    std::vector<TrackKey> scale;       // in order of time
    std::vector<std::pair<double, bool>>
        visibility; // steps: (time, visible); visible before the first
};

/// A coordinate frame. Parents come before their children.
struct Node {
    std::string name;         // as the file has it
    std::int32_t parent = -1; // -1: the world
    glm::dmat4 local{1.0};    // parent_from_node, where there is no track
    std::int32_t track = -1;  // replaces local where >= 0
};

/// A part's shape at one time: the shape between two keys is interpolated linearly, clamped
/// outside.
struct MorphKey {
    double time_s = 0;               // when
    std::vector<glm::vec3> position; // (vertices of the part) object space
    std::vector<glm::vec3> normal;   // (vertices of the part) unit, object space
};

/// Writes the object-space positions and unit normals of the part's vertices [first, last) at a
/// time. position[0] and normal[0] are vertex `first`. Called from several threads for disjoint
/// ranges.
using Deform = std::function<void(
    double time_s, std::size_t first, std::size_t last, glm::vec3* position, glm::vec3* normal)>;

/// A run of vertices and triangles that share a node and a material.
struct Part {
    std::string name;                 // as the file has it
    std::uint32_t node = 0;           // of Scene::nodes
    std::uint32_t material = 0;       // of Scene::materials
    std::uint32_t first_vertex = 0;   // of Scene::position
    std::uint32_t vertex_count = 0;   // used by triangles of this part only
    std::uint32_t first_triangle = 0; // of Scene::index
    std::uint32_t triangle_count = 0; // of this part
    std::vector<MorphKey> morph;      // empty: rigid
    Deform deform; // set: writes the part's vertices, the arrays of the scene are unused
};

/// A light that does not fade with distance.
struct Light {
    /// Where its light comes from.
    enum class Kind {
        point,       // from a position to all sides
        spot,        // from a position into a cone
        directional, // parallel, from infinitely far away
    };
    Kind kind = Kind::point;        // which members count
    glm::dvec3 position{0};         // point, spot
    glm::dvec3 direction{0, -1, 0}; // spot, directional: the way the light goes, of any length
    double inner_rad = 0; // spot: half angle of the cone that has the full light, 0 to outer
    double outer_rad = 0.78539816339744831; // spot: half angle where it ends, in (0, pi / 2);
                                            // between the two it fades as smoothstep of the cosine
    glm::vec3 color{1.0f};                  // linear Rec.709, may exceed 1
    std::int32_t track = -1;                // >= 0: the track's translation replaces the position
};

/// A scene as read, immutable after loading. Right-handed, y up.
///
/// Triangle ids number `index` from 0 in file order and stay below kNoItem.
struct Scene {
    std::string name; // names it in messages

    std::vector<Node> nodes;   // parents before their children
    std::vector<Track> tracks; // of nodes, lights and the camera
    std::vector<Part> parts;   // in order of their triangles and of their vertices, without gaps
    std::vector<Material> materials; // of parts
    std::vector<Texture> textures;   // of materials
    std::vector<Light> lights;       // without one only ambient light is left

    std::vector<glm::vec3> position;  // (V) object space
    std::vector<glm::vec3> normal;    // (V) unit, object space
    std::vector<glm::vec2> uv;        // (V), or empty where no part has a texture
    std::vector<glm::uvec3> index;    // (T) into position, counter-clockwise = front
    std::vector<std::uint32_t> owner; // (T) the part of each triangle

    std::optional<Camera> camera;   // none: see framing_camera
    std::int32_t camera_track = -1; // moves and turns the camera; -1: it stands still
    glm::vec3 background{0.0f};     // where nothing is seen, linear
    glm::vec3 ambient{1.0f};        // multiplies every material's ambient colour

    double begin_s = 0; // the animation's range; equal where nothing moves
    double end_s = 0;   // not before begin_s
    int frames = 1;     // that the file asks for, from begin_s to end_s

    std::vector<std::string> warnings; // what a reader had to do without, one line each

    /// Every file that it was read from, as it was opened (relative to the working folder of that
    /// time): the scene's own first, then included files, material libraries and textures, also those
    /// that turned out damaged. Empty where there was none. Not to be written over: see file.h.
    std::vector<std::string> files;

    /// V.
    std::size_t vertex_count() const { return vertices; }
    /// T.
    std::size_t triangle_count() const { return index.size(); }

    /// V. `position` and `normal` may be empty where every part deforms.
    std::size_t vertices = 0;
};

/// The scene posed at one time, in world space. Memory is reused from pose to pose. The scene lives
/// at least as long as the world.
struct World {
    std::shared_ptr<const Scene> scene;     // what was posed; shared, so that it lives as long
    double time_s = 0;                      // of the pose
    std::vector<glm::vec3> position;        // (V)
    std::vector<glm::vec3> normal;          // (V) unit
    std::vector<Light> lights;              // world space
    Camera camera;                          // of that time
    std::vector<glm::dmat4> node_matrix;    // (nodes) world_from_node
    std::vector<std::uint8_t> node_visible; // (nodes)
    std::vector<glm::dvec3> normal_sum;     // memory that update_normals keeps here
};

/// How files become scenes.
struct LoadSettings {
    double crease_angle_rad = 3.14159265358979323846; // smooth normals across smaller angles
    int sphere_segments = 32; // around the equator; half as many from pole to pole, 2 at least
    int cone_segments = 32;   // around the axis

    static constexpr int kMinSegments = 3;    // of both
    static constexpr int kMaxSegments = 4096; // of both
};

/// Reads a scene: a file (.aff .nff .ply .stl .obj), or builtin:torus, builtin:robots,
/// builtin:wave?n=N (N triangles, 2 to 10,000,000).
///
/// throws  FileError: missing, unreadable, malformed (names file and line or element)
///         SceneError: an index out of range, a coordinate that is not finite
///         ArgumentError: an unknown built-in or a parameter out of range
Scene load_scene(const std::string& name, const LoadSettings& settings = {});

/// A scene from arrays, one part, one material. normal and uv may be empty (flat normals are made).
/// throws  SceneError as load_scene
Scene scene_from_arrays(std::vector<glm::vec3> position, std::vector<glm::uvec3> index,
    std::vector<glm::vec3> normal = {}, std::vector<glm::vec2> uv = {});

/// Poses the scene at a time, clamped to nothing: tracks clamp themselves. Deterministic, whatever
/// the number of threads; writes into `world` and allocates nothing once its sizes have settled.
/// A part of an invisible node collapses to a point, which no ray hits. A scene without a camera
/// gets framing_camera's. The world shares the scene: what was posed stays valid whatever becomes
/// of the caller's own pointer.
///
///     const auto scene = std::make_shared<const Scene>(load_scene("robots.aff"));
///     pose(scene, 0.5, world);
///
/// throws  SceneError: a posed coordinate that is not finite (names the part), an index out of
/// range
///         ArgumentError: a time that is not finite, no scene
void pose(std::shared_ptr<const Scene> scene, double time_s, World& world, int threads = 1);

/// The same for a scene that is posed once: it is moved into the world.
void pose(Scene&& scene, double time_s, World& world, int threads = 1);

/// A camera that sees the whole world from the front, slightly above.
Camera framing_camera(const World& world);

/// Smallest and largest posed coordinate on each axis. An empty world gives two zeros.
std::array<glm::vec3, 2> bounds(const World& world);

} // namespace firsthit
