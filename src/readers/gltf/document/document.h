// document.h - a glTF 2.0 file as plain data: checked once, defaults filled in, not yet a scene.
#pragma once

#include "readers/gltf/data/accessor.h"
#include "readers/gltf/document/material.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace firsthit::gltf {

struct Asset {
    std::string version; // "2.0"
    std::string generator;
    std::string copyright;
};

struct SceneRoots {
    std::string name;
    std::vector<int> nodes; // each without a parent, none twice
};

struct Node {
    std::string name;
    int parent = kNone; // nodes are trees: one parent, no cycles
    std::vector<int> children;
    std::optional<glm::mat4> matrix; // in place of the three below
    glm::vec3 translation{0.0f};
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f}; // w, x, y, z; as given, perhaps not of unit length
    glm::vec3 scale{1.0f};
    int mesh = kNone;
    int skin = kNone;           // only where there is a mesh
    std::vector<float> weights; // of the mesh's morph targets; empty: the mesh's own
    int camera = kNone;
    int light = kNone; // KHR_lights_punctual
    /// EXT_mesh_gpu_instancing: TRANSLATION (VEC3), ROTATION (VEC4, x y z w), SCALE (VEC3), of equal
    /// counts. Other names are left out. Empty: the node's mesh stands once.
    std::map<std::string, int> instancing;
};

enum class PrimitiveMode {
    kPoints = 0,
    kLines = 1,
    kLineLoop = 2,
    kLineStrip = 3,
    kTriangles = 4,
    kTriangleStrip = 5,
    kTriangleFan = 6,
};

/// From the attribute's name to its accessor: POSITION, NORMAL, TANGENT, TEXCOORD_n, COLOR_n,
/// JOINTS_n, WEIGHTS_n, and application-specific ones that start with an underscore.
///
/// The types of all but the last are checked: POSITION, NORMAL VEC3; TANGENT VEC4, in a morph target
/// VEC3; TEXCOORD_n VEC2; COLOR_n VEC3 or VEC4; JOINTS_n VEC4, without a sign, not normalised; WEIGHTS_n VEC4.
using Attributes = std::map<std::string, int>;

/// What KHR_draco_mesh_compression packed is unpacked: attributes and indices are as of any other.
struct Primitive {
    PrimitiveMode mode = PrimitiveMode::kTriangles;
    Attributes attributes; // all of the same count
    int indices = kNone;   // SCALAR, without a sign
    int material = kNone;  // none: Material{}. The primitive's own, whatever the variants say
    std::vector<Attributes> targets; // of morphing, of the same count as the attributes
};

struct Mesh {
    std::string name;
    std::vector<Primitive> primitives; // all with the same number of targets, perhaps empty ones
    std::vector<float> weights;        // one a target, or empty: zeros
};

struct Skin {
    std::string name;
    std::vector<int> joints;           // nodes, at least one
    int inverse_bind_matrices = kNone; // MAT4, at least as many as joints; none: identities
    int skeleton = kNone;
};

enum class Interpolation { kLinear, kStep, kCubicSpline };

struct AnimationSampler {
    int input = kNone;  // SCALAR, float, seconds, at least one
    int output = kNone; // see AnimationChannel
    Interpolation interpolation = Interpolation::kLinear;
};

enum class AnimatedProperty { kTranslation, kRotation, kScale, kWeights };

/// Channels without a target node, and of other properties, are left out. The output has a value for each
/// input, three (in-tangent, value, out-tangent) where it is a cubic spline: VEC3, for rotations VEC4
/// (x y z w), for weights as many SCALARs a value as the mesh has targets.
struct AnimationChannel {
    int sampler = kNone; // of the animation
    int node = kNone;
    AnimatedProperty property = AnimatedProperty::kTranslation;
};

struct Animation {
    std::string name;
    std::vector<AnimationSampler> samplers;
    std::vector<AnimationChannel> channels;
};

struct Camera {
    std::string name;
    bool orthographic = false;
    float y_fov_rad = 0.0f; // perspective, vertical
    float aspect = 0.0f;    // perspective, width / height; 0: the picture's
    float x_mag = 0.0f;     // orthographic, half the width and half the height of what is seen
    float y_mag = 0.0f;
    float z_near = 0.0f;
    float z_far = 0.0f; // 0: infinite (perspective)
};

enum class LightType { kDirectional, kPoint, kSpot };

/// KHR_lights_punctual. Shines along the node's -z.
struct Light {
    std::string name;
    LightType type = LightType::kPoint;
    glm::vec3 color{1.0f};
    float intensity = 1.0f;      // candela; lux where it is directional
    float range = 0.0f;          // 0: unlimited
    float inner_cone_rad = 0.0f; // half angles
    float outer_cone_rad = 0.785398163f;
};

/// Every number that names a node, mesh, accessor, ... is kNone, where a comment allows it, or in range.
struct Document {
    std::string name; // of the file, for messages
    std::filesystem::path folder;
    Asset asset;
    std::vector<std::string> extensions_used;
    std::vector<std::string> extensions_required;
    int scene = kNone; // the one that the file asks for
    std::vector<SceneRoots> scenes;
    std::vector<Node> nodes;
    std::vector<Mesh> meshes;
    std::vector<Skin> skins;
    std::vector<Animation> animations;
    std::vector<Camera> cameras;
    std::vector<Light> lights;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<Image> images;
    std::vector<Accessor> accessors; // the file's own first, then those of Draco
    std::vector<BufferView> buffer_views;
    std::vector<Buffer> buffers;

    std::vector<std::string> warnings; // what is not shown or was odd, each once
    /// Paths of all files that it is made of, also images and what is missing, the document itself first
    /// where it was read from a path.
    std::vector<std::string> files;
};

/// Reads a .gltf or .glb file, told apart by content, and the buffers that it names. Images are read
/// when they are asked for (images.h).
///
/// limits  4 GiB a file, 2^24 JSON values, nested 64 deep, 2^28 elements an accessor. What accessors
///         and compressed buffer views unpack to is at most 256 MiB plus 64 times what was read. Trees of nodes are at most 1024 deep.
/// throws  FileError: missing, malformed, beyond a limit, or it needs what is not supported (names
///         file and place)
Document read_document(const std::filesystem::path& path);

/// The same for bytes in memory.
/// name    for messages
/// folder  where other files are; empty: none are read, and their buffers have no bytes
Document read_document(
    const std::string& name, std::string bytes, const std::filesystem::path& folder);

} // namespace firsthit::gltf
