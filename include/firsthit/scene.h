// scene.h - a scene as it was read.
#pragma once

#include <firsthit/animation.h>
#include <firsthit/environment.h>
#include <firsthit/light.h>
#include <firsthit/material.h>
#include <firsthit/mesh.h>
#include <firsthit/texture.h>
#include <firsthit/view.h>
#include <firsthit/world.h>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace firsthit {

/// The id that stands for no triangle: the item of a ray that hits nothing.
inline constexpr std::uint32_t kNoItem = 0xFFFFFFFFu;

/// A coordinate frame. Parents come before their children.
struct Node {
    std::string name{};                       // as the file has it
    std::int32_t parent = -1;                 // -1: the world
    glm::dmat4 local{1.0};                    // parent_from_node, where there is no `transform`
    std::optional<NodeTransform> transform{}; // replaces local; what channels of clips change
    std::vector<float>
        weights{}; // of the morph targets of its meshes, at rest; empty: the meshes' own
};

/// A mesh placed in the scene: a run of vertices and triangles that share a node and a material.
struct Instance {
    std::string name;                 // as the file has it
    std::uint32_t node = 0;           // of Scene::nodes; moves it where it has no skin
    std::uint32_t material = 0;       // of Scene::materials
    std::uint32_t first_vertex = 0;   // of Scene::position
    std::uint32_t vertex_count = 0;   // used by triangles of this instance only
    std::uint32_t first_triangle = 0; // of Scene::index
    std::uint32_t triangle_count = 0; // of this instance
    std::vector<MorphKey> morph;      // empty: its shape has no keys
    Deform deform; // set: writes the instance's vertices, the arrays of the scene are unused
    std::int32_t shape = -1; // of Scene::shapes: morph targets and skin weights; -1 none
    std::int32_t skin = -1; // of Scene::skins: moves its vertices in the place of the node; -1 none
    bool facet_normals = false; // normals are those of the posed triangles; its triangles share no
                                // vertices: triangle t has 3 t, 3 t + 1, 3 t + 2

    /// Whether posing changes more than its place: it has keys, a Deform, morph targets or a skin.
    bool changes_shape() const { return !morph.empty() || deform || shape >= 0; }
};

/// A camera of a scene.
struct SceneCamera {
    std::string name{};     // as the file has it
    Camera camera{};        // in the space of the node
    std::int32_t node = -1; // of Scene::nodes, moves and turns it; -1: the world
};

/// A scene as read, immutable after loading. Right-handed, y up.
///
/// Triangle ids number `index` from 0 in file order and stay below kNoItem.
struct Scene {
    std::string name; // used in messages

    std::vector<Node> nodes; // parents before their children
    std::vector<Clip> clips; // animations, of which a pose has one; the first if nobody chooses
    std::vector<Instance>
        instances; // in order of their triangles and of their vertices, without gaps
    std::vector<MeshShape> shapes;    // of instances that have morph targets or skin weights
    std::vector<Skin> skins;          // of instances
    std::vector<Material> materials;  // of instances
    std::vector<Texture> textures;    // of materials
    std::vector<Light> lights;        // without one only ambient light is left
    std::vector<SceneCamera> cameras; // none: see framing_camera
    std::vector<glm::vec3> position;  // (V) object space
    std::vector<glm::vec3> normal;    // (V) unit, object space
    std::vector<glm::vec2> uv;        // (V), or empty where no instance has a texture
    std::vector<glm::vec2> uv1;       // (V) a second set, or empty
    std::vector<glm::vec4> color;     // (V) linear red, green, blue, and alpha; or empty: 1
    std::vector<glm::vec4> tangent;   // (V) unit, object space, w = 1 or -1 (see Mesh); or empty
    std::vector<glm::uvec3> index;    // (T) into position, counter-clockwise = front
    std::vector<std::uint32_t> owner; // (T) the instance of each triangle

    glm::ivec2 picture_size{0}; // width and height in pixels that the file asks for; 0: nothing

    glm::vec3 background{0.0f}; // where nothing is seen, linear
    glm::vec3 ambient{1.0f};    // multiplies every material's ambient colour
    Environment environment;    // what metallic-roughness materials reflect

    std::vector<std::string> extensions; // that its file uses, by name (glTF)
    std::vector<std::string> warnings;   // what the reader could not represent, one line each

    /// The paths of all files that the scene was read from, as they were opened (relative to the
    /// working folder at that time): first the scene's own file, then included files, material
    /// libraries and textures, including those that turned out to be damaged. Empty if there was no
    /// file. A program should not overwrite them: see check_inputs_stay in file.h.
    std::vector<std::string> files;

    /// V, the number of vertices.
    std::size_t vertex_count() const { return vertices; }
    /// T, the number of triangles.
    std::size_t triangle_count() const { return index.size(); }

    /// V, the number of vertices. `position` and `normal` may be empty if all instances have `deform`.
    std::size_t vertices = 0;

    /// Where a clip begins, seconds; 0 where there is no such clip.
    double begin_s(std::int32_t clip = 0) const
    {
        return has_clip(clip) ? clips[std::size_t(clip)].begin_s : 0;
    }
    /// Where a clip ends, seconds; 0 where there is no such clip.
    double end_s(std::int32_t clip = 0) const
    {
        return has_clip(clip) ? clips[std::size_t(clip)].end_s : 0;
    }
    /// How many frames a clip's file asks for; 1 where there is no such clip.
    int frames(std::int32_t clip = 0) const
    {
        return has_clip(clip) ? clips[std::size_t(clip)].frames : 1;
    }

    /// Whether it has a clip of this number.
    bool has_clip(std::int32_t clip) const { return clip >= 0 && std::size_t(clip) < clips.size(); }
};

/// Options of reading scenes.
struct LoadSettings {
    double crease_angle_rad = 3.14159265358979323846 / 6; // smooth normals across smaller angles
    int sphere_segments = 32; // around the equator; half as many from pole to pole, 2 at least
    int cone_segments = 32;   // around the axis
    std::string scene{}; // of a file with several: its name or number; empty: the file's own choice
    bool strict = false; // a warning is an error

    static constexpr int kMinSegments = 3;    // least value of both numbers of segments
    static constexpr int kMaxSegments = 4096; // greatest value of both
};

/// Reads a scene: a file (.gltf .glb .fbx .dae .3mf .aff .nff .ply .stl .obj .off), or builtin:torus,
/// builtin:robots, builtin:room, builtin:wave?n=N (N triangles, 2 to 10,000,000). Numbered files: see sequence.h. Large
/// .ply .stl .obj files are read by a thread for each core; the scene does not depend on their number.
///
/// throws  FileError: missing, unreadable, malformed (names file and line or element); with `strict` also
///         where there is a warning
///         SceneError: an index out of range, a coordinate that is not finite
///         ArgumentError: an unknown built-in or a parameter out of range
Scene load_scene(const std::string& name, const LoadSettings& settings = {});

/// Makes a scene with one instance and one material from arrays.
/// position  (V) metres
/// index     (T) vertices of each triangle, counter-clockwise seen from its front
/// normal    (V) unit; or empty: triangles are shaded flat, and vertices are split where necessary
/// uv        (V); or empty
/// throws    SceneError: as load_scene
Scene scene_from_arrays(std::vector<glm::vec3> position, std::vector<glm::uvec3> index,
    std::vector<glm::vec3> normal = {}, std::vector<glm::vec2> uv = {});

} // namespace firsthit
