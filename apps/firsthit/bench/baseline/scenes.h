// scenes.h - what is measured beside Embree.
#pragma once

#include "bench/bench_options.h"

#include <firsthit/scene.h>
#include <firsthit/view.h>

#include <memory>
#include <string>
#include <vector>

namespace firsthit::cli::bench {

/// A scene around one time, mostly with one light.
struct BaselineScene {
    std::string name;
    std::shared_ptr<const Scene> scene; // null: it is missing
    double time_s = 0;                  // of the animation, where the frames begin
    std::string note = {};              // what stands in for it, or why it is missing
    bool kept = true;                   // Embree may know what does not move
    double asked_map = 0;   // how many times faster than Embree we want to be, at least;
    double asked_exact = 0; // 0: nothing is asked
    Camera camera = {};     // of a scene that has none: frames it

    bool moves() const;
    View view(const World& world, const Size& size) const;
};

/// Seconds from frame to frame.
inline constexpr double kFrameTime_s = 1.0 / 30;

/// One with a name; its other lights are left out.
BaselineScene baseline_scene(std::string name, Scene scene, double time_s = 0);
/// One with a name and all its lights.
BaselineScene lit_scene(std::string name, Scene scene, double time_s = 0);

/// Torus, bunny, twisting bunny, robots, room, dragon, wave: those of --quick are small ones.
/// throws  as load_scene of the robots' file
std::vector<BaselineScene> baseline_scenes(const BenchOptions& options);

/// Of `baseline_scenes`, by name; null: there is none.
const BaselineScene* find_scene(const std::vector<BaselineScene>& scenes, const std::string& name);

} // namespace firsthit::cli::bench
