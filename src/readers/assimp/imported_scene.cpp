// imported_scene.cpp - the nodes of what Assimp has read, and meshes where they place them.
#include "readers/assimp/imported_scene.h"

#include "readers/assimp/convert.h"
#include "scene/model/default_material.h"

#include <firsthit/error.h>

#include <assimp/metadata.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace firsthit {
namespace {

/// A scene has at most so many vertices or triangles more than its meshes: nodes that repeat a mesh cannot take
/// all memory.
constexpr std::size_t kMostRepeated = std::size_t(1) << 24;

/// Which nodes channels move: those have a transform in parts.
std::set<std::string> moved_nodes(const aiScene& scene)
{
    std::set<std::string> names;
    for (unsigned a = 0; a < scene.mNumAnimations; ++a)
        for (unsigned c = 0; c < scene.mAnimations[a]->mNumChannels; ++c)
            names.insert(scene.mAnimations[a]->mChannels[c]->mNodeName.C_Str());
    return names;
}

NodeTransform parts_of(aiMatrix4x4 matrix)
{
    aiVector3D scale, translation;
    aiQuaternion rotation;
    matrix.Decompose(scale, rotation, translation);
    NodeTransform made;
    made.translation = vector_of(translation);
    made.scale = vector_of(scale);
    const glm::dquat turn(rotation.w, rotation.x, rotation.y, rotation.z);
    const double length = std::sqrt(glm::dot(turn, turn));
    if (length > 0 && std::isfinite(length)) made.rotation = turn * (1 / length);
    return made;
}

/// An axis of an FBX file: x, y or z, forwards or backwards; 0 where it says none.
glm::dvec3 axis_of(const aiMetadata& data, const std::string& name)
{
    std::int32_t axis = -1, sign = 1;
    if (!data.Get(name, axis) || axis < 0 || axis > 2) return glm::dvec3(0);
    data.Get(name + "Sign", sign);
    glm::dvec3 made(0);
    made[axis] = sign < 0 ? -1 : 1;
    return made;
}

/// FBX says which of its axes point to the right, upwards and to the front, and its unit in centimetres.
glm::dmat4 metres_from_fbx(const aiMetadata* data)
{
    if (!data) return glm::dmat4(0.01);
    const glm::dvec3 right = axis_of(*data, "CoordAxis"), up = axis_of(*data, "UpAxis");
    glm::dmat3 turn(1);
    // Whatever is said of the front: scenes are not mirrored.
    if (right != glm::dvec3(0) && up != glm::dvec3(0) && glm::dot(right, up) == 0)
        turn = glm::transpose(glm::dmat3(right, up, glm::cross(right, up)));
    double unit = 1;
    float single = 1;
    if (!data->Get("UnitScaleFactor", unit) && data->Get("UnitScaleFactor", single)) unit = single;
    if (!(unit > 0 && std::isfinite(unit))) unit = 1;
    return glm::dmat4(turn * (0.01 * unit));
}

} // namespace

ImportedScene::ImportedScene(const aiScene& from, std::string name, std::string extension,
    const std::filesystem::path& folder, double unit_m)
    : from_(from),
      name_(std::move(name)),
      extension_(std::move(extension)),
      unit_m_(unit_m),
      builder_(std::filesystem::path(name_).filename().string()),
      materials_(from, name_, folder, builder_),
      mesh_(from.mNumMeshes, -1)
{
}

Scene ImportedScene::make()
{
    builder_.set_ambient(glm::vec3(kMeshAmbient));
    add_nodes();
    materials_.add_all();
    add_instances();
    add_cameras();
    add_lights();
    add_clips();
    return builder_.build();
}

/// Assimp has turned COLLADA's axes and units already. 3MF has z upwards.
glm::dmat4 ImportedScene::world_from_file() const
{
    glm::dmat4 matrix(1);
    if (extension_ == ".fbx") {
        matrix = metres_from_fbx(from_.mMetaData);
        matrix[3][3] = 1;
    } else if (extension_ == ".3mf") {
        const glm::dmat3 turn({1, 0, 0}, {0, 0, -1}, {0, 1, 0}); // exactly
        matrix = glm::dmat4(turn * unit_m_);
        matrix[3][3] = 1;
    }
    return matrix;
}

/// Depth first, a node before its children, without recursion. The first one turns and scales the file.
void ImportedScene::add_nodes()
{
    const std::set<std::string> moved = moved_nodes(from_);
    struct Open {
        const aiNode* node;
        std::int32_t parent;
    };
    const auto root =
        static_cast<std::int32_t>(builder_.add_node({.name = name_, .local = world_from_file()}));
    std::vector<Open> open{{from_.mRootNode, root}};
    while (!open.empty()) {
        const auto [node, parent] = open.back();
        open.pop_back();
        Node made;
        made.name = node->mName.C_Str();
        made.parent = parent;
        if (moved.contains(made.name))
            made.transform = parts_of(node->mTransformation);
        else
            made.local = matrix_of(node->mTransformation);
        const std::uint32_t number = builder_.add_node(std::move(made));
        node_.try_emplace(node->mName.C_Str(), number);
        nodes_.push_back({node, number});
        for (unsigned c = node->mNumChildren; c > 0; --c)
            open.push_back({node->mChildren[c - 1], static_cast<std::int32_t>(number)});
    }
}

void ImportedScene::add_instances()
{
    std::size_t room = kMostRepeated;
    for (unsigned m = 0; m < from_.mNumMeshes; ++m)
        room += std::max(from_.mMeshes[m]->mNumVertices, from_.mMeshes[m]->mNumFaces);
    bool any = false;
    for (const PlacedNode& placed : nodes_)
        for (unsigned k = 0; k < placed.from->mNumMeshes; ++k) {
            const unsigned m = placed.from->mMeshes[k];
            if (m >= from_.mNumMeshes)
                throw SceneError(fmt::format("{}: node '{}': mesh {} is out of range ({})", name_,
                    placed.from->mName.C_Str(), m, from_.mNumMeshes));
            const aiMesh& mesh = *from_.mMeshes[m];
            if (mesh.mNumFaces == 0 || !(mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE)) continue;
            const std::size_t size = std::max(mesh.mNumVertices, mesh.mNumFaces);
            if (size > room)
                throw SceneError(fmt::format(
                    "{}: nodes repeat meshes to more than {} vertices", name_, kMostRepeated));
            room -= size;
            const std::int32_t skin = skin_of(m, placed.number);
            builder_.add_instance(mesh_of(m), placed.number, materials_.number(mesh.mMaterialIndex),
                skin, mesh.mName.C_Str());
            any = true;
        }
    if (!any) throw FileError(fmt::format("{}: there are no triangles to show", name_));
}

void ImportedScene::warn_once(const std::string& warning)
{
    if (warned_.insert(warning).second) builder_.warn(warning);
}

std::int32_t ImportedScene::node_named(const aiString& name) const
{
    const auto found = node_.find(name.C_Str());
    return found == node_.end() ? -1 : static_cast<std::int32_t>(found->second);
}

} // namespace firsthit
