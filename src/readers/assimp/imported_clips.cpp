// imported_clips.cpp - the animations of what Assimp has read.
#include "readers/assimp/convert.h"
#include "readers/assimp/imported_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace firsthit {
namespace {

/// Where a file does not say how many ticks a second has, Assimp means this many.
constexpr double kTicksPerSecond = 25;

/// Of clips that do not say how many frames they want.
constexpr double kFramesPerSecond = 30;

/// Keys in order of time; others are left out, as are times that are not finite.
class Keys {
  public:
    Keys(std::uint32_t node, Channel::Path path, double ticks_per_second)
        : ticks_per_second_(ticks_per_second)
    {
        made_.node = node;
        made_.path = path;
    }

    /// returns  whether the values of that key are to follow
    bool add(double ticks)
    {
        const double time_s = ticks / ticks_per_second_;
        if (!std::isfinite(time_s)) return false;
        if (!made_.time_s.empty() && time_s <= made_.time_s.back()) return false;
        made_.time_s.push_back(time_s);
        return true;
    }

    void value(double x) { made_.value.push_back(std::isfinite(x) ? x : 0); }

    void value(const aiVector3D& v)
    {
        for (const float x : {v.x, v.y, v.z}) value(double(x));
    }

    /// A rotation of length 0 is none.
    void value(const aiQuaternion& q)
    {
        const double length = std::sqrt(
            double(q.x) * q.x + double(q.y) * q.y + double(q.z) * q.z + double(q.w) * q.w);
        const bool good = length > 0 && std::isfinite(length);
        for (const float x : {q.x, q.y, q.z}) value(good ? x / length : 0.0);
        value(good ? q.w / length : 1.0);
    }

    void move_to(Clip& clip)
    {
        if (!made_.time_s.empty()) clip.channels.push_back(std::move(made_));
    }

  private:
    Channel made_;
    double ticks_per_second_;
};

template <class Key>
void add_keys(const Key* keys, unsigned count, Keys made, Clip& clip)
{
    for (unsigned k = 0; k < count; ++k)
        if (made.add(keys[k].mTime)) made.value(keys[k].mValue);
    made.move_to(clip);
}

/// How many morph targets the meshes of a node have; 0 where they differ.
unsigned targets_of(const aiScene& scene, const aiNode& node)
{
    unsigned targets = 0;
    for (unsigned m = 0; m < node.mNumMeshes; ++m) {
        const unsigned of_mesh = scene.mMeshes[node.mMeshes[m]]->mNumAnimMeshes;
        if (m > 0 && of_mesh != targets) return 0;
        targets = of_mesh;
    }
    return targets;
}

void add_weights(const aiMeshMorphAnim& from, unsigned targets, Keys made, Clip& clip)
{
    std::vector<double> weight;
    for (unsigned k = 0; k < from.mNumKeys; ++k) {
        const aiMeshMorphKey& key = from.mKeys[k];
        weight.assign(targets, 0);
        for (unsigned n = 0; n < key.mNumValuesAndWeights; ++n)
            if (key.mValues[n] < targets) weight[key.mValues[n]] = key.mWeights[n];
        if (!made.add(key.mTime)) continue;
        for (const double w : weight) made.value(w);
    }
    made.move_to(clip);
}

/// FBX writes "node*0": the name of the node and the number of its mesh.
std::string_view node_part(std::string_view name)
{
    return name.substr(0, name.rfind('*'));
}

void set_range(Clip& clip)
{
    bool first = true;
    for (const Channel& channel : clip.channels) {
        const double begin_s = channel.time_s.front(), end_s = channel.time_s.back();
        clip.begin_s = first ? begin_s : std::min(clip.begin_s, begin_s);
        clip.end_s = first ? end_s : std::max(clip.end_s, end_s);
        first = false;
    }
    const double frames = std::round((clip.end_s - clip.begin_s) * kFramesPerSecond) + 1;
    clip.frames = static_cast<int>(std::clamp(frames, 1.0, 1e9));
}

} // namespace

void ImportedScene::add_clips()
{
    for (unsigned a = 0; a < from_.mNumAnimations; ++a) {
        const aiAnimation& from = *from_.mAnimations[a];
        const double ticks = from.mTicksPerSecond > 0 && std::isfinite(from.mTicksPerSecond)
                                 ? from.mTicksPerSecond
                                 : kTicksPerSecond;
        Clip clip;
        clip.name = from.mName.C_Str();
        std::set<std::uint32_t> moved;
        for (unsigned c = 0; c < from.mNumChannels; ++c) {
            const aiNodeAnim& channel = *from.mChannels[c];
            const std::int32_t found = node_named(channel.mNodeName);
            const auto node = static_cast<std::uint32_t>(found);
            if (found < 0 || !moved.insert(node).second) {
                warn_once(
                    fmt::format("{}: animation '{}': what moves '{}' is left out: there is no "
                                "such node, or it moves already",
                        name_, clip.name, channel.mNodeName.C_Str()));
                continue;
            }
            using Path = Channel::Path;
            add_keys(channel.mPositionKeys, channel.mNumPositionKeys,
                Keys(node, Path::translation, ticks), clip);
            add_keys(channel.mRotationKeys, channel.mNumRotationKeys,
                Keys(node, Path::rotation, ticks), clip);
            add_keys(channel.mScalingKeys, channel.mNumScalingKeys, Keys(node, Path::scale, ticks),
                clip);
        }
        std::set<std::uint32_t> morphed;
        for (unsigned c = 0; c < from.mNumMorphMeshChannels; ++c) {
            const aiMeshMorphAnim& channel = *from.mMorphMeshChannels[c];
            const std::string name(node_part(channel.mName.C_Str()));
            const auto found = std::find_if(nodes_.begin(), nodes_.end(),
                [&](const PlacedNode& node) { return name == node.from->mName.C_Str(); });
            const unsigned targets = found == nodes_.end() ? 0 : targets_of(from_, *found->from);
            if (targets == 0 || !morphed.insert(found->number).second) continue;
            add_weights(channel, targets, Keys(found->number, Channel::Path::weights, ticks), clip);
        }
        if (from.mNumMeshChannels > 0)
            warn_once(fmt::format(
                "{}: animation '{}' exchanges meshes, which is not shown", name_, clip.name));
        if (clip.channels.empty()) continue;
        set_range(clip);
        builder_.add_clip(std::move(clip));
    }
}

} // namespace firsthit
