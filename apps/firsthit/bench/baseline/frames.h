// frames.h - measures one scene's frames by the cpu engine and by Embree, in turn.
#pragma once

#include "bench/baseline/frame_maker.h"
#include "bench/baseline/picture_difference.h"
#include "bench/baseline/scenes.h"
#include "bench/measure/quartiles.h"

#include <firsthit/baseline.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace firsthit::cli::bench {

/// Who makes the frames.
enum class Side {
    map,      // the cpu engine with shadow maps
    exact,    // the cpu engine with exact shadows
    embree8,  // packets of 8 rays
    embree16, // packets of 16, where Embree has instructions for them
};
inline constexpr std::array<Side, 4> kSides{Side::map, Side::exact, Side::embree8, Side::embree16};

/// "ours, map", ...
std::string_view side_name(Side side);

struct SideTimes {
    Side side = Side::map;
    Quartiles ms;                           // whole frames: from posing to the film
    Quartiles cpu_ms;                       // of the processor's time (FrameMaker::cpu_ms)
    Stages stages;                          // medians
    std::vector<double> all_ms, all_cpu_ms; // (rounds)
};

/// A scene, a size, a number of threads.
struct BaselineRow {
    std::string scene;
    std::uint64_t triangles = 0;
    Size size;
    int threads = 1;
    BaselineUpdate update = BaselineUpdate::refit; // which gave Embree the shortest frames
    std::vector<SideTimes> sides = {};
    std::optional<PictureDifference> exact = {}, map = {}; // of our pictures and Embree's last ones
    std::string unavailable = {};                          // why nothing was measured
    std::string embree_failure = {};                       // why Embree has no times

    const SideTimes* find(Side side) const;
    /// How many times longer `theirs` takes than `ours`, round by round; count 0: not measured.
    Quartiles ratio(Side ours, Side theirs) const;
    Quartiles cpu_ratio(Side ours, Side theirs) const;
};

struct RowSettings {
    Size size;
    int threads = 1;
    int rounds = 1; // at most; fewer where frames take long, unless they were asked for
    bool fewer = true;
    bool pictures = true; // compare them
};

/// The scene is posed a little later from round to round, for all sides at the same times. Embree's
/// update is the one whose frames are shortest in a short trial.
BaselineRow measure_row(const BaselineScene& scene, const RowSettings& settings);

/// The same for several scenes, all frame by frame in turn, so that their times may be compared.
/// returns  (scenes), in their order
std::vector<BaselineRow> measure_together(
    std::span<const BaselineScene> scenes, const RowSettings& settings);

} // namespace firsthit::cli::bench
