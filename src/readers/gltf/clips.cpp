// clips.cpp - the animations of a glTF document.
#include "readers/gltf/scene_maker.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace firsthit::gltf {
namespace {

constexpr double kFramesPerSecond = 30; // glTF asks for none

Channel::Path path_of(AnimatedProperty property)
{
    switch (property) {
    case AnimatedProperty::kTranslation:
        return Channel::Path::translation;
    case AnimatedProperty::kRotation:
        return Channel::Path::rotation;
    case AnimatedProperty::kScale:
        return Channel::Path::scale;
    case AnimatedProperty::kWeights:
        break;
    }
    return Channel::Path::weights;
}

Channel::Interpolation interpolation_of(Interpolation interpolation)
{
    switch (interpolation) {
    case Interpolation::kStep:
        return Channel::Interpolation::step;
    case Interpolation::kLinear:
        return Channel::Interpolation::linear;
    case Interpolation::kCubicSpline:
        break;
    }
    return Channel::Interpolation::cubic;
}

} // namespace

void SceneMaker::add_channel(
    const Animation& animation, const AnimationChannel& channel, Clip& clip)
{
    const auto n = static_cast<std::size_t>(channel.node);
    const Node& node = document_.nodes[n];
    const AnimationSampler& sampler = animation.samplers[static_cast<std::size_t>(channel.sampler)];
    const bool moves = channel.property != AnimatedProperty::kWeights;
    if (moves && node.matrix) {
        warn_once(fmt::format("{}: animation '{}' moves node '{}', which has a matrix: it stays",
            document_.name, clip.name, node.name));
        return;
    }
    Channel made;
    made.node = static_cast<std::uint32_t>(scene_node_[n]);
    made.path = path_of(channel.property);
    made.interpolation = interpolation_of(sampler.interpolation);
    const auto same = [&](const Channel& other) {
        return other.node == made.node && other.path == made.path;
    };
    if (std::any_of(clip.channels.begin(), clip.channels.end(), same)) {
        warn_once(
            fmt::format("{}: animation '{}' moves node '{}' twice in one way: the first counts",
                document_.name, clip.name, node.name));
        return;
    }
    const std::vector<float> times = read_floats(document_, sampler.input, 1);
    if (times.empty()) return;
    const int components = channel.property == AnimatedProperty::kRotation  ? 4
                           : channel.property == AnimatedProperty::kWeights ? 1
                                                                            : 3;
    const std::vector<float> values = read_floats(document_, sampler.output, components);
    made.time_s.assign(times.begin(), times.end());
    made.value.assign(values.begin(), values.end());
    clip.channels.push_back(std::move(made));
}

void SceneMaker::add_clips()
{
    for (const Animation& animation : document_.animations) {
        Clip clip;
        clip.name = animation.name;
        for (const AnimationChannel& channel : animation.channels)
            add_channel(animation, channel, clip);
        bool first = true;
        for (const Channel& channel : clip.channels) {
            const double begin_s = channel.time_s.front(), end_s = channel.time_s.back();
            clip.begin_s = first ? begin_s : std::min(clip.begin_s, begin_s);
            clip.end_s = first ? end_s : std::max(clip.end_s, end_s);
            first = false;
        }
        const double frames = std::round((clip.end_s - clip.begin_s) * kFramesPerSecond) + 1;
        clip.frames = static_cast<int>(std::clamp(frames, 1.0, 1e9));
        builder_.add_clip(std::move(clip));
    }
}

} // namespace firsthit::gltf
