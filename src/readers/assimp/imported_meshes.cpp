// imported_meshes.cpp - the meshes of what Assimp has read, their morph targets and skins.
#include "readers/assimp/convert.h"
#include "readers/assimp/imported_scene.h"
#include "scene/model/tangents.h"

#include <firsthit/error.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace firsthit {
namespace {

/// What follows the bone that a vertex has most of is most important; the others of 8 are nearly nothing.
constexpr unsigned kMostInfluences = 8;

glm::vec3 unit(const aiVector3D& v)
{
    const glm::vec3 n = vector_of(v);
    const float length = glm::length(n);
    return length > 0 && std::isfinite(length) ? n / length : glm::vec3(0, 0, 1);
}

std::vector<glm::vec2> coordinates_of(const aiMesh& from, unsigned set)
{
    std::vector<glm::vec2> made;
    if (!from.HasTextureCoords(set)) return made;
    for (unsigned v = 0; v < from.mNumVertices; ++v)
        made.emplace_back(from.mTextureCoords[set][v].x, from.mTextureCoords[set][v].y);
    return made;
}

/// How far a target's vertices are from the mesh's; nothing where it has none.
std::vector<glm::vec3> differences(
    const aiVector3D* target, const aiVector3D* base, unsigned vertices)
{
    std::vector<glm::vec3> made;
    if (!target || !base) return made;
    for (unsigned v = 0; v < vertices; ++v) made.push_back(vector_of(target[v] - base[v]));
    return made;
}

void add_targets(const aiMesh& from, Mesh& mesh)
{
    for (unsigned t = 0; t < from.mNumAnimMeshes; ++t) {
        const aiAnimMesh& target = *from.mAnimMeshes[t];
        if (target.mNumVertices != from.mNumVertices) continue;
        mesh.shape.targets.push_back({.name = target.mName.C_Str(),
            .position = differences(target.mVertices, from.mVertices, from.mNumVertices),
            .normal = differences(target.mNormals, from.mNormals, from.mNumVertices)});
        mesh.shape.weights.push_back(0);
    }
}

SkinWeights weights_of(const aiMesh& from)
{
    struct Influence {
        float weight;
        std::uint16_t joint;
    };
    std::vector<std::vector<Influence>> of_vertex(from.mNumVertices);
    for (unsigned b = 0; b < from.mNumBones; ++b) {
        const aiBone& bone = *from.mBones[b];
        for (unsigned w = 0; w < bone.mNumWeights; ++w) {
            const auto [vertex, weight] = bone.mWeights[w];
            if (vertex < from.mNumVertices && weight > 0 && std::isfinite(weight))
                of_vertex[vertex].push_back({weight, static_cast<std::uint16_t>(b)});
        }
    }
    SkinWeights skin;
    for (std::vector<Influence>& influences : of_vertex) {
        std::stable_sort(influences.begin(), influences.end(),
            [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
        influences.resize(std::min<std::size_t>(influences.size(), kMostInfluences));
        // The joint after those of the bones is that of the node.
        if (influences.empty())
            influences.push_back({1, static_cast<std::uint16_t>(from.mNumBones)});
        skin.influences = std::max(skin.influences, static_cast<int>(influences.size()));
    }
    const auto each = static_cast<std::size_t>(skin.influences);
    skin.joint.assign(each * from.mNumVertices, 0);
    skin.weight.assign(each * from.mNumVertices, 0);
    for (std::size_t v = 0; v < of_vertex.size(); ++v) {
        double sum = 0;
        for (const Influence& influence : of_vertex[v]) sum += influence.weight;
        for (std::size_t k = 0; k < of_vertex[v].size(); ++k) {
            skin.joint[each * v + k] = of_vertex[v][k].joint;
            skin.weight[each * v + k] = static_cast<float>(of_vertex[v][k].weight / sum);
        }
    }
    return skin;
}

} // namespace

Mesh mesh_of(const aiMesh& from, const std::string& name)
{
    Mesh mesh;
    mesh.shape.name = from.mName.C_Str();
    for (unsigned v = 0; v < from.mNumVertices; ++v)
        mesh.position.push_back(vector_of(from.mVertices[v]));
    if (from.HasNormals())
        for (unsigned v = 0; v < from.mNumVertices; ++v)
            mesh.normal.push_back(unit(from.mNormals[v]));
    mesh.uv = coordinates_of(from, 0);
    mesh.uv1 = coordinates_of(from, 1);
    if (from.HasVertexColors(0))
        for (unsigned v = 0; v < from.mNumVertices; ++v) {
            const aiColor4D& c = from.mColors[0][v];
            mesh.color.emplace_back(c.r, c.g, c.b, c.a);
        }
    for (unsigned f = 0; f < from.mNumFaces; ++f) {
        const aiFace& face = from.mFaces[f];
        if (face.mNumIndices != 3) continue;
        for (unsigned k = 0; k < 3; ++k)
            if (face.mIndices[k] >= from.mNumVertices)
                throw SceneError(fmt::format("{}: mesh '{}': vertex {} is out of range ({})", name,
                    from.mName.C_Str(), face.mIndices[k], from.mNumVertices));
        mesh.index.emplace_back(face.mIndices[0], face.mIndices[1], face.mIndices[2]);
    }
    add_targets(from, mesh);
    if (from.HasBones() && from.mNumBones < std::numeric_limits<std::uint16_t>::max())
        mesh.shape.skin = weights_of(from);
    return mesh;
}

std::uint32_t ImportedScene::mesh_of(unsigned number)
{
    if (mesh_[number] < 0) {
        const aiMesh& from = *from_.mMeshes[number];
        Mesh mesh = firsthit::mesh_of(from, name_);
        const TextureRef normals = materials_.normal_texture(from.mMaterialIndex);
        const std::vector<glm::vec2>& uv = normals.uv_set == 0 ? mesh.uv : mesh.uv1;
        if (normals.texture >= 0 && !uv.empty() && !mesh.normal.empty())
            mesh.tangent = derived_tangents(mesh, uv, normals.transform);
        mesh_[number] = builder_.add_mesh(std::move(mesh));
    }
    return static_cast<std::uint32_t>(mesh_[number]);
}

/// The joints of a mesh at a node; -1: it has no bones.
std::int32_t ImportedScene::skin_of(unsigned number, std::uint32_t node)
{
    const aiMesh& from = *from_.mMeshes[number];
    if (!from.HasBones() || from.mNumBones >= std::numeric_limits<std::uint16_t>::max()) return -1;
    Skin skin;
    skin.name = from.mName.C_Str();
    for (unsigned b = 0; b < from.mNumBones; ++b) {
        const aiBone& bone = *from.mBones[b];
        const std::int32_t joint = node_named(bone.mName);
        if (joint < 0)
            warn_once(
                fmt::format("{}: mesh '{}': there is no node of bone '{}': what it moves stays "
                            "with the mesh",
                    name_, from.mName.C_Str(), bone.mName.C_Str()));
        skin.joints.push_back(joint < 0 ? node : static_cast<std::uint32_t>(joint));
        skin.inverse_bind.push_back(joint < 0 ? glm::dmat4(1) : matrix_of(bone.mOffsetMatrix));
    }
    skin.joints.push_back(node);
    skin.inverse_bind.emplace_back(1);
    return static_cast<std::int32_t>(builder_.add_skin(std::move(skin)));
}

} // namespace firsthit
