// read_primitive.cpp - the vertices and triangles of a glTF primitive.
#include "readers/gltf/scene_maker.h"

#include <firsthit/error.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace firsthit::gltf {
namespace {

int accessor_of(const Attributes& attributes, const std::string& name)
{
    const auto found = attributes.find(name);
    return found == attributes.end() ? kNone : found->second;
}

/// The vectors of an attribute; nothing where the primitive does not have it.
template <class Vector>
std::vector<Vector> read_vectors(
    const Document& document, const Attributes& attributes, const std::string& name)
{
    const int accessor = accessor_of(attributes, name);
    if (accessor == kNone) return {};
    const std::vector<float> values = read_floats(document, accessor, Vector::length());
    std::vector<Vector> vectors(values.size() / static_cast<std::size_t>(Vector::length()));
    if (!values.empty()) std::memcpy(vectors.data(), values.data(), values.size() * sizeof(float));
    return vectors;
}

/// Unit; 0 stays 0: shading then takes the triangle's own.
void normalize(std::vector<glm::vec3>& normals)
{
    for (glm::vec3& n : normals) {
        const glm::dvec3 wide(n);
        const double length = glm::length(wide);
        n = length > 0 ? glm::vec3(wide / length) : glm::vec3(0);
    }
}

/// A scene counts v from a picture's bottom, glTF from its top.
std::vector<glm::vec2> read_uv(
    const Document& document, const Attributes& attributes, const std::string& name)
{
    std::vector<glm::vec2> uv = read_vectors<glm::vec2>(document, attributes, name);
    for (glm::vec2& at : uv) at.y = 1 - at.y;
    return uv;
}

std::vector<glm::vec4> read_colors(const Document& document, const Attributes& attributes)
{
    const int accessor = accessor_of(attributes, "COLOR_0");
    if (accessor == kNone) return {};
    if (document.accessors[static_cast<std::size_t>(accessor)].components() == 4)
        return read_vectors<glm::vec4>(document, attributes, "COLOR_0");
    std::vector<glm::vec4> colors;
    for (const glm::vec3& rgb : read_vectors<glm::vec3>(document, attributes, "COLOR_0"))
        colors.emplace_back(rgb, 1.0f);
    return colors;
}

/// One set of four joints and weights of every vertex.
struct JointSet {
    std::vector<std::uint32_t> joint;
    std::vector<float> weight;
};

/// All sets that have a weight.
std::vector<JointSet> read_joint_sets(const Document& document, const Attributes& attributes)
{
    std::vector<JointSet> sets;
    for (int k = 0;; ++k) {
        const int joints = accessor_of(attributes, fmt::format("JOINTS_{}", k));
        const int weights = accessor_of(attributes, fmt::format("WEIGHTS_{}", k));
        if (joints == kNone || weights == kNone) return sets;
        JointSet set{read_uints(document, joints, 4), read_floats(document, weights, 4)};
        if (std::any_of(set.weight.begin(), set.weight.end(), [](float w) { return w != 0; }))
            sets.push_back(std::move(set));
    }
}

/// Weights are divided by their sum. A vertex without weights goes to the joint `identity`.
SkinWeights skin_weights(const Document& document, const Mesh& mesh, const Primitive& primitive,
    std::size_t identity, bool& used_identity)
{
    const std::vector<JointSet> sets = read_joint_sets(document, primitive.attributes);
    SkinWeights skin;
    const std::size_t vertices =
        document.accessors[static_cast<std::size_t>(accessor_of(primitive.attributes, "POSITION"))]
            .count;
    const std::size_t influences = 4 * std::max<std::size_t>(1, sets.size());
    skin.influences = static_cast<int>(influences);
    skin.joint.assign(vertices * influences, 0);
    skin.weight.assign(vertices * influences, 0.0f);
    for (std::size_t v = 0; v < vertices; ++v) {
        double sum = 0;
        for (const JointSet& set : sets)
            for (std::size_t k = 0; k < 4; ++k) sum += double(set.weight[4 * v + k]);
        if (!(std::abs(sum) > 0)) {
            skin.joint[v * influences] = static_cast<std::uint16_t>(identity);
            skin.weight[v * influences] = 1;
            used_identity = true;
            continue;
        }
        for (std::size_t s = 0; s < sets.size(); ++s)
            for (std::size_t k = 0; k < 4; ++k) {
                const float weight = sets[s].weight[4 * v + k];
                if (weight == 0) continue; // its joint may be any number
                const std::uint32_t joint = sets[s].joint[4 * v + k];
                if (joint >= identity)
                    throw SceneError(
                        fmt::format("{}: mesh '{}': vertex {}: joint {} is out of range ({} exist)",
                            document.name, mesh.name, v, joint, identity));
                skin.joint[v * influences + 4 * s + k] = static_cast<std::uint16_t>(joint);
                skin.weight[v * influences + 4 * s + k] = static_cast<float>(double(weight) / sum);
            }
    }
    return skin;
}

} // namespace

std::vector<glm::uvec3> triangles_of(PrimitiveMode mode, const std::vector<std::uint32_t>& corners)
{
    std::vector<glm::uvec3> triangles;
    if (corners.size() < 3) return triangles;
    if (mode == PrimitiveMode::kTriangles) {
        triangles.reserve(corners.size() / 3);
        for (std::size_t k = 0; k + 3 <= corners.size(); k += 3)
            triangles.emplace_back(corners[k], corners[k + 1], corners[k + 2]);
        return triangles;
    }
    triangles.reserve(corners.size() - 2);
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
        if (mode == PrimitiveMode::kTriangleStrip)
            triangles.emplace_back(corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]);
        else
            triangles.emplace_back(corners[i + 1], corners[i + 2], corners[0]);
    }
    return triangles;
}

firsthit::Mesh read_primitive(const Document& document, const Mesh& mesh,
    const Primitive& primitive, std::size_t skin_joints, bool& identity_joint)
{
    const Attributes& attributes = primitive.attributes;
    firsthit::Mesh made;
    made.shape.name = mesh.name;
    made.position = read_vectors<glm::vec3>(document, attributes, "POSITION");
    made.index =
        triangles_of(primitive.mode, read_indices(document, primitive, made.position.size()));
    made.normal = read_vectors<glm::vec3>(document, attributes, "NORMAL");
    normalize(made.normal);
    made.uv = read_uv(document, attributes, "TEXCOORD_0");
    made.uv1 = read_uv(document, attributes, "TEXCOORD_1");
    made.color = read_colors(document, attributes);
    // Without normals the specification has tangents derived too.
    if (!made.normal.empty())
        made.tangent = read_vectors<glm::vec4>(document, attributes, "TANGENT");
    for (glm::vec4& t : made.tangent) t.w = t.w < 0 ? -1.0f : 1.0f;
    for (const Attributes& target : primitive.targets) {
        MorphTarget& to = made.shape.targets.emplace_back();
        to.position = read_vectors<glm::vec3>(document, target, "POSITION");
        if (!made.normal.empty()) to.normal = read_vectors<glm::vec3>(document, target, "NORMAL");
        if (!made.tangent.empty())
            to.tangent = read_vectors<glm::vec3>(document, target, "TANGENT");
    }
    made.shape.weights = mesh.weights;
    if (skin_joints > 0)
        made.shape.skin = skin_weights(document, mesh, primitive, skin_joints, identity_joint);
    return made;
}

} // namespace firsthit::gltf
