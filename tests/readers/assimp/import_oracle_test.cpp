// import_oracle_test.cpp - poses of the models of Debian's assimp-testmodels are those that Assimp's own nodes,
// keys and bones say, worked out in the plainest way. Skipped where the package is not installed.
#include "readers/assimp/import_file.h"
#include "readers/assimp/read_assimp.h"

#include <firsthit/error.h>

#include <assimp/anim.h>
#include <assimp/scene.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace firsthit {
namespace {

namespace fs = std::filesystem;

const fs::path kModels = "/usr/share/assimp/models";

/// The value of keys at a time, in ticks.
template <class Key, class Mix>
auto value_at(const Key* keys, unsigned count, double ticks, const Mix& mix)
{
    unsigned after = 0;
    while (after < count && keys[after].mTime <= ticks) ++after;
    const Key& a = keys[after > 0 ? after - 1 : 0];
    const Key& b = keys[std::min(after, count - 1)];
    const double span = b.mTime - a.mTime;
    return mix(a.mValue, b.mValue, span > 0 ? float((ticks - a.mTime) / span) : 0.0f);
}

aiMatrix4x4 local_at(const aiScene& scene, const aiNode& node, double time_s)
{
    if (scene.mNumAnimations == 0) return node.mTransformation;
    const aiAnimation& clip = *scene.mAnimations[0];
    const double rate = clip.mTicksPerSecond > 0 ? clip.mTicksPerSecond : 25;
    for (unsigned c = 0; c < clip.mNumChannels; ++c) {
        const aiNodeAnim& channel = *clip.mChannels[c];
        if (channel.mNodeName != node.mName) continue;
        const auto mix = [](const aiVector3D& a, const aiVector3D& b, float u) {
            return a + (b - a) * u;
        };
        const auto turn = [](const aiQuaternion& a, const aiQuaternion& b, float u) {
            aiQuaternion made;
            aiQuaternion::Interpolate(made, a, b, u);
            return made.Normalize();
        };
        return {value_at(channel.mScalingKeys, channel.mNumScalingKeys, time_s * rate, mix),
            value_at(channel.mRotationKeys, channel.mNumRotationKeys, time_s * rate, turn),
            value_at(channel.mPositionKeys, channel.mNumPositionKeys, time_s * rate, mix)};
    }
    return node.mTransformation;
}

/// Where nodes are at a time: each, and the first of a name.
struct Places {
    std::map<const aiNode*, aiMatrix4x4> of;
    std::map<std::string, aiMatrix4x4> named;
};

void place(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent, double time_s,
    Places& places)
{
    const aiMatrix4x4 here = parent * local_at(scene, node, time_s);
    places.of[&node] = here;
    places.named.try_emplace(node.mName.C_Str(), here);
    for (unsigned c = 0; c < node.mNumChildren; ++c)
        place(scene, *node.mChildren[c], here, time_s, places);
}

/// The vertices of all instances, in the order of the nodes.
void add_vertices(const aiScene& scene, const aiNode& node, const Places& places,
    std::vector<glm::vec3>& vertices)
{
    const aiMatrix4x4 here = places.of.at(&node);
    for (unsigned k = 0; k < node.mNumMeshes; ++k) {
        const aiMesh& mesh = *scene.mMeshes[node.mMeshes[k]];
        std::vector<aiVector3D> sum(mesh.mNumVertices);
        std::vector<float> weight(mesh.mNumVertices, 0);
        for (unsigned b = 0; b < mesh.mNumBones; ++b) {
            const aiBone& bone = *mesh.mBones[b];
            const aiMatrix4x4 matrix = places.named.at(bone.mName.C_Str()) * bone.mOffsetMatrix;
            for (unsigned w = 0; w < bone.mNumWeights; ++w) {
                const aiVertexWeight& follows = bone.mWeights[w];
                sum[follows.mVertexId] +=
                    matrix * mesh.mVertices[follows.mVertexId] * follows.mWeight;
                weight[follows.mVertexId] += follows.mWeight;
            }
        }
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
            const aiVector3D p = weight[v] > 0 ? sum[v] / weight[v] : here * mesh.mVertices[v];
            vertices.emplace_back(p.x, p.y, p.z);
        }
    }
    for (unsigned c = 0; c < node.mNumChildren; ++c)
        add_vertices(scene, *node.mChildren[c], places, vertices);
}

/// Metres of a unit of the file; 0 where it does not have y upwards.
float scale_of(const aiScene& scene, const std::string& extension)
{
    if (extension != ".fbx") return 1;
    float unit = 1;
    int up = 1;
    scene.mMetaData->Get("UnitScaleFactor", unit);
    scene.mMetaData->Get("UpAxis", up);
    return up == 1 ? unit * 0.01f : 0;
}

TEST(ImportOracle, PosesAreThoseOfAssimpsNodesKeysAndBones)
{
    if (!fs::exists(kModels)) GTEST_SKIP() << "apt-get install assimp-testmodels";
    int files = 0, skinned = 0, moving = 0;
    for (const char* folder : {"FBX", "Collada"})
        for (const fs::directory_entry& entry : fs::directory_iterator(kModels / folder)) {
            std::string extension = entry.path().extension().string();
            for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
            if (!is_assimp_extension(extension)) continue;
            Scene scene;
            try {
                scene = load_scene(entry.path().string());
            } catch (const Error&) {
                continue; // what is refused is listed in the documentation
            }
            std::ifstream file(entry.path(), std::ios::binary);
            const std::string bytes{std::istreambuf_iterator<char>(file), {}};
            const ImportedFile imported = import_file(
                entry.path().string(), bytes, extension, LoadSettings{}.crease_angle_rad);
            const float scale = scale_of(*imported.scene, extension);
            if (scale == 0) continue;
            ++files;
            skinned += !scene.skins.empty();
            moving += !scene.clips.empty();
            const auto shared = std::make_shared<const Scene>(std::move(scene));
            for (const double share : {0.0, 0.3, 0.77}) {
                const double time_s =
                    shared->begin_s() + share * (shared->end_s() - shared->begin_s());
                Places places;
                place(*imported.scene, *imported.scene->mRootNode, {}, time_s, places);
                std::vector<glm::vec3> wanted;
                add_vertices(*imported.scene, *imported.scene->mRootNode, places, wanted);
                World world;
                pose(shared, time_s, world);
                ASSERT_EQ(world.position.size(), wanted.size()) << entry.path();
                const auto [low, high] = bounds(world);
                const float size = glm::length(glm::max(glm::abs(low), glm::abs(high)));
                for (std::size_t v = 0; v < wanted.size(); ++v)
                    ASSERT_LT(glm::distance(world.position[v], wanted[v] * scale), 1e-4f * size)
                        << entry.path() << " at " << time_s << " s, vertex " << v;
            }
        }
    EXPECT_GE(files, 30);
    EXPECT_GE(skinned, 4);
    EXPECT_GE(moving, 4);
}

} // namespace
} // namespace firsthit
