// sequence_frame.h - one frame of a sequence, and what is between two.
#pragma once

#include "readers/sequence/topology.h"

#include <firsthit/scene.h>

#include <memory>

namespace firsthit {

/// A frame as it was read.
struct SequenceFrame {
    std::shared_ptr<const Scene> scene; // flat (see flatten.h)
    std::shared_ptr<const Topology> topology;
};

/// A scene that is frame `a` at time a_s, frame `b` at time b_s, and between them interpolated: see
/// SceneSequence. Corners that are the same vertex in both are one. It shares the scenes of both frames.
///
/// map  match(*a.topology, *b.topology)
Scene scene_between(
    const SequenceFrame& a, const SequenceFrame& b, const CornerMap& map, double a_s, double b_s);

} // namespace firsthit
