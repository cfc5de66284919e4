// check_animation.cpp - are clips, skins, morph targets and skin weights of a scene sound?
#include "scene/model/check_animation.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace firsthit {
namespace {

using Path = Channel::Path;
using Interpolation = Channel::Interpolation;

[[noreturn]] void refuse(const Scene& scene, const std::string& what)
{
    throw SceneError(fmt::format("{}: {}", scene.name.empty() ? "scene" : scene.name, what));
}

const char* name_of(Path path)
{
    switch (path) {
    case Path::translation:
        return "translation";
    case Path::rotation:
        return "rotation";
    case Path::scale:
        return "scale";
    case Path::weights:
        return "weights";
    case Path::visibility:
        break;
    }
    return "visibility";
}

template <class Values>
bool all_finite(const Values& values)
{
    return std::all_of(values.begin(), values.end(), [](auto x) { return std::isfinite(x); });
}

bool is_finite(const TcbKey& key)
{
    // A sum of products with 0 is 0 where every factor is finite.
    const double sum = key.time_s * 0 + key.value.x * 0 + key.value.y * 0 + key.value.z * 0 +
                       key.value.w * 0 + key.tension * 0 + key.continuity * 0 + key.bias * 0;
    return sum == 0;
}

void check_tcb(const Scene& scene, const Channel& channel, const std::string& what)
{
    if (channel.path == Path::weights || channel.path == Path::visibility)
        refuse(scene, what + ": only translation, rotation and scale can be a tcb spline");
    if (channel.tcb.empty()) refuse(scene, what + ": no key");
    for (std::size_t k = 0; k < channel.tcb.size(); ++k)
        if (!is_finite(channel.tcb[k]))
            refuse(scene, fmt::format("{} key {} is not finite", what, k));
}

void check_keys(const Scene& scene, const Channel& channel, const std::string& what)
{
    const std::size_t keys = channel.time_s.size();
    if (keys == 0) refuse(scene, what + ": no key");
    const bool any_order = channel.path == Path::visibility;
    for (std::size_t k = 0; k < keys; ++k) {
        if (!std::isfinite(channel.time_s[k]))
            refuse(scene, fmt::format("{}: the time of key {} is not finite", what, k));
        if (k > 0 && !any_order && channel.time_s[k] < channel.time_s[k - 1])
            refuse(scene,
                fmt::format("{}: the time of key {} is before that of the one before", what, k));
    }
    const std::size_t each = channel.interpolation == Interpolation::cubic ? 3 * keys : keys;
    const std::size_t components = channel.path == Path::rotation     ? 4
                                   : channel.path == Path::visibility ? 1
                                   : channel.path == Path::weights
                                       ? channel.value.size() / each // any whole number
                                       : 3;
    if (channel.value.size() != each * components)
        refuse(scene, fmt::format("{}: {} numbers for {} keys", what, channel.value.size(), keys));
    if (!all_finite(channel.value)) refuse(scene, what + ": a value is not finite");
}

void check_clip(const Scene& scene, const Clip& clip)
{
    if (!std::isfinite(clip.begin_s) || !std::isfinite(clip.end_s) || clip.end_s < clip.begin_s)
        refuse(scene,
            fmt::format("clip '{}': from {} s to {} s", clip.name, clip.begin_s, clip.end_s));
    if (clip.frames < 1) refuse(scene, fmt::format("clip '{}': {} frames", clip.name, clip.frames));
    // All nodes and paths that the clip moves, sorted. (Not a std::set: the memory sanitizer cannot see what the
    // standard library's trees write.)
    std::vector<std::pair<std::uint32_t, Path>> seen;
    seen.reserve(clip.channels.size());
    for (const Channel& channel : clip.channels) seen.emplace_back(channel.node, channel.path);
    std::sort(seen.begin(), seen.end());
    for (std::size_t c = 0; c < clip.channels.size(); ++c) {
        const Channel& channel = clip.channels[c];
        if (channel.node >= scene.nodes.size())
            refuse(scene, fmt::format("clip '{}': channel {}: node {} is out of range ({})",
                              clip.name, c, channel.node, scene.nodes.size()));
        const Node& node = scene.nodes[channel.node];
        const std::string what = fmt::format("clip '{}': {} of node {} '{}'", clip.name,
            name_of(channel.path), channel.node, node.name);
        const auto same =
            std::equal_range(seen.begin(), seen.end(), std::pair(channel.node, channel.path));
        if (same.second - same.first > 1) refuse(scene, what + ": a second channel");
        const bool moves = channel.path != Path::weights && channel.path != Path::visibility;
        if (moves && !node.transform)
            refuse(scene, what + ": the node has a matrix and no transform that could change");
        if (channel.interpolation == Interpolation::tcb)
            check_tcb(scene, channel, what);
        else
            check_keys(scene, channel, what);
    }
}

void check_skin(const Scene& scene, std::size_t number)
{
    const Skin& skin = scene.skins[number];
    const std::string what = fmt::format("skin {} '{}'", number, skin.name);
    if (skin.joints.empty()) refuse(scene, what + " has no joint");
    if (skin.joints.size() > 65536)
        refuse(scene,
            fmt::format("{} has {} joints, at most 65536 are accepted", what, skin.joints.size()));
    if (skin.inverse_bind.size() != skin.joints.size())
        refuse(scene, fmt::format("{} has {} inverse bind matrices for {} joints", what,
                          skin.inverse_bind.size(), skin.joints.size()));
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
        if (skin.joints[j] >= scene.nodes.size())
            refuse(scene, fmt::format("{}: joint {}: node {} is out of range ({})", what, j,
                              skin.joints[j], scene.nodes.size()));
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                if (!std::isfinite(skin.inverse_bind[j][column][row]))
                    refuse(scene, fmt::format("{}: the matrix of joint {} is not finite", what, j));
    }
}

void check_target(const Scene& scene, const std::vector<glm::vec3>& values, std::size_t vertices,
    const std::string& what)
{
    if (!values.empty() && values.size() != vertices)
        refuse(scene,
            fmt::format("{}: {} displacements for {} vertices", what, values.size(), vertices));
    for (const glm::vec3& v : values)
        if (!std::isfinite(v.x * 0 + v.y * 0 + v.z * 0))
            refuse(scene, what + ": a displacement is not finite");
}

} // namespace

void check_animation(const Scene& scene)
{
    for (const Clip& clip : scene.clips) check_clip(scene, clip);
    for (std::size_t s = 0; s < scene.skins.size(); ++s) check_skin(scene, s);
}

void check_deformation(const Scene& scene, const Instance& instance, const std::string& what)
{
    if (instance.shape < 0) return;
    const MeshShape& shape = scene.shapes[static_cast<std::size_t>(instance.shape)];
    const std::size_t vertices = instance.vertex_count;
    for (std::size_t t = 0; t < shape.targets.size(); ++t) {
        const std::string target = fmt::format("{}: morph target {}", what, t);
        check_target(scene, shape.targets[t].position, vertices, target);
        check_target(scene, shape.targets[t].normal, vertices, target);
        check_target(scene, shape.targets[t].tangent, vertices, target);
    }
    if (!all_finite(shape.weights))
        refuse(scene, what + ": a weight of its morph targets is not finite");

    const SkinWeights& skin = shape.skin;
    const std::size_t weights = vertices * static_cast<std::size_t>(std::max(0, skin.influences));
    if (skin.influences < 0 || skin.joint.size() != weights || skin.weight.size() != weights)
        refuse(scene, fmt::format("{}: {} joints and {} weights for {} vertices with {} influences",
                          what, skin.joint.size(), skin.weight.size(), vertices, skin.influences));
    if (!all_finite(skin.weight)) refuse(scene, what + ": a weight of its skin is not finite");
    if (instance.skin < 0) return;
    const std::size_t joints = scene.skins[static_cast<std::size_t>(instance.skin)].joints.size();
    for (std::size_t k = 0; k < skin.joint.size(); ++k)
        if (skin.joint[k] >= joints)
            refuse(
                scene, fmt::format("{}: vertex {}: joint {} is out of range ({})", what,
                           k / static_cast<std::size_t>(skin.influences), skin.joint[k], joints));
}

} // namespace firsthit
