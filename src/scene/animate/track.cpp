// track.cpp - all that moves one node by Kochanek-Bartels splines.
#include "scene/animate/track.h"

#include "scene/animate/tcb_spline.h"

#include <limits>

namespace firsthit {

void add_channels(const Track& track, std::uint32_t node, Clip& clip)
{
    const auto add_spline = [&](Channel::Path path, const std::vector<TcbKey>& keys) {
        if (keys.empty()) return;
        Channel& channel = clip.channels.emplace_back();
        channel.node = node;
        channel.path = path;
        channel.interpolation = Channel::Interpolation::tcb;
        channel.tcb = keys;
    };
    add_spline(Channel::Path::translation, track.translation);
    add_spline(Channel::Path::rotation, track.rotation);
    add_spline(Channel::Path::scale, track.scale);
    if (track.visibility.empty()) return;
    Channel& channel = clip.channels.emplace_back();
    channel.node = node;
    channel.path = Channel::Path::visibility;
    channel.interpolation = Channel::Interpolation::step;
    channel.time_s.push_back(std::numeric_limits<double>::lowest());
    channel.value.push_back(1);
    for (const auto& [time_s, visible] : track.visibility) {
        channel.time_s.push_back(time_s);
        channel.value.push_back(visible ? 1 : 0);
    }
}

NodeTransform transform_at(const Track& track, double time_s)
{
    NodeTransform transform;
    if (!track.translation.empty())
        transform.translation = evaluate_vector(track.translation, time_s);
    if (!track.rotation.empty()) transform.rotation = evaluate_rotation(track.rotation, time_s);
    if (!track.scale.empty()) transform.scale = evaluate_vector(track.scale, time_s);
    return transform;
}

} // namespace firsthit
