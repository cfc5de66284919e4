// ways.h - the kinds of frames that the paper's section 5 compares.
#pragma once

#include <firsthit/render.h>

#include <string>
#include <vector>

namespace firsthit::cli::bench {

/// The paper shoots every n-th ray, without saying which n.
inline constexpr int kPaperInterleave = 2;

/// A way to make a frame.
struct Way {
    std::string name;
    Settings settings;
};

/// "hybrid sync", "hybrid", "hybrid maps", "hybrid interleaved", "hybrid lazy3", "hybrid lazy5", "hybrid
/// full3", "hybrid full5", "gpu", "gpu maps", "cpu", "cpu interleaved", "cpu maps", "cpu exact". Where
/// the name does not say so: asynchronous readback, no multisampling, no shadows.
std::vector<Way> paper_ways();

/// The one of this name.
Way paper_way(const std::string& name);

} // namespace firsthit::cli::bench
