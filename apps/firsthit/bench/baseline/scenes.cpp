// scenes.cpp - what is measured beside Embree.
#include "bench/baseline/scenes.h"
#include "bench/measure/one_light.h"

#include "bench/baseline/moving_scenes.h"
#include "common/output.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace firsthit::cli::bench {

namespace {

BaselineScene asked(BaselineScene scene, double map, double exact)
{
    scene.asked_map = map;
    scene.asked_exact = exact;
    return scene;
}

BaselineScene missing(std::string name, const BenchOptions& options, const std::string& file)
{
    return {.name = std::move(name),
        .scene = nullptr,
        .note = fmt::format("{} is missing: scripts/fetch_scenes.sh fetches it",
            (std::filesystem::path(options.scenes) / file).string())};
}

Scene loaded(const std::string& file)
{
    Scene scene = load_scene(file, kSmooth);
    print_warnings(scene.warnings);
    return scene;
}

/// A still mesh twice: where everything is made anew in every frame, as is asked, and where Embree may
/// keep its tree, and we our shadow map.
void add_still(const std::string& name, const Scene& scene, double map, double exact,
    std::vector<BaselineScene>& scenes)
{
    BaselineScene anew = asked(baseline_scene(name, with_moving_lights(scene)), map, exact);
    anew.kept = false;
    scenes.push_back(std::move(anew));
    scenes.push_back(baseline_scene(name + ", still", scene));
}

void add_bunny(const BenchOptions& options, std::vector<BaselineScene>& scenes)
{
    const std::string file = fetched_scene(options, "bunny.stl");
    if (file.empty()) {
        scenes.push_back(missing("bunny, still", options, "bunny.stl"));
        scenes.push_back(asked(missing("bunny, twisting", options, "bunny.stl"), 6, 4));
        return;
    }
    Scene bunny = loaded(file);
    scenes.push_back(baseline_scene("bunny, still", bunny));
    scenes.push_back(asked(baseline_scene("bunny, twisting", twisting(std::move(bunny))), 6, 4));
}

void add_robots(const BenchOptions& options, std::vector<BaselineScene>& scenes)
{
    const bool bart = !options.bart.empty();
    const std::vector<double> times =
        bart ? std::vector<double>{10, 30, 45} : std::vector<double>{2.5, 5, 7.5};
    BaselineScene robots = baseline_scene("", loaded(robots_scene(options)));
    robots.note = bart ? "BART's scene" : "stands in for BART's Robot.aff, which --bart names";
    for (const double time_s : times) {
        robots.name = fmt::format("{}, t = {:g}", bart ? "Robot.aff" : "robots", time_s);
        robots.time_s = time_s;
        scenes.push_back(asked(robots, 6, 4));
    }
}

/// A furnished room through which a toy drives: with one lamp, as the other scenes are measured, and with
/// its six lamps and the sun.
void add_room(std::vector<BaselineScene>& scenes)
{
    constexpr double kTime_s = 5;
    scenes.push_back(baseline_scene("room, t = 5", load_scene("builtin:room"), kTime_s));
    scenes.push_back(lit_scene("room, t = 5, 7 lights", load_scene("builtin:room"), kTime_s));
}

} // namespace

bool BaselineScene::moves() const
{
    const auto changes = [](const Instance& instance) { return instance.changes_shape(); };
    if (!scene) return false;
    if (std::any_of(scene->instances.begin(), scene->instances.end(), changes)) return true;
    // Nodes that a channel moves, and all below them.
    std::vector<bool> moved(scene->nodes.size(), false);
    for (const Clip& clip : scene->clips)
        for (const Channel& channel : clip.channels) moved[channel.node] = true;
    for (std::size_t n = 0; n < moved.size(); ++n)
        if (scene->nodes[n].parent >= 0 && moved[std::size_t(scene->nodes[n].parent)])
            moved[n] = true;
    return std::any_of(scene->instances.begin(), scene->instances.end(),
        [&](const Instance& instance) { return moved[instance.node]; });
}

View BaselineScene::view(const World& world, const Size& size) const
{
    return {.camera = !scene->cameras.empty() ? world.camera : camera,
        .width = size.width,
        .height = size.height,
        .region = {}};
}

BaselineScene baseline_scene(std::string name, Scene scene, double time_s)
{
    leave_one_light(scene);
    return lit_scene(std::move(name), std::move(scene), time_s);
}

BaselineScene lit_scene(std::string name, Scene scene, double time_s)
{
    BaselineScene made{.name = std::move(name),
        .scene = std::make_shared<const Scene>(std::move(scene)),
        .time_s = time_s};
    World world;
    pose(made.scene, time_s, world);
    made.camera = framing_camera(world);
    return made;
}

std::vector<BaselineScene> baseline_scenes(const BenchOptions& options)
{
    std::vector<BaselineScene> scenes;
    add_still("torus", load_scene("builtin:torus"), 8, 5, scenes);
    if (options.quick) {
        scenes.push_back(baseline_scene("torus, twisting", twisting(load_scene("builtin:torus"))));
        scenes.push_back(baseline_scene("wave, 10^3", load_scene("builtin:wave?n=1000")));
        if (!options.bart.empty()) add_robots(options, scenes);
        return scenes;
    }
    add_bunny(options, scenes);
    add_robots(options, scenes);
    add_room(scenes);
    const std::string dragon = fetched_scene(options, "dragon.ply");
    if (dragon.empty())
        scenes.push_back(asked(missing("dragon", options, "dragon.ply"), 4, 3));
    else
        add_still("dragon", loaded(dragon), 4, 3, scenes);
    for (int power = 4; power <= 7; ++power) {
        BaselineScene wave = baseline_scene(fmt::format("wave, 10^{}", power),
            load_scene(fmt::format("builtin:wave?n=1{}", std::string(std::size_t(power), '0'))));
        if (power == 6) wave = asked(std::move(wave), 4, 3);
        if (power == 7) wave = asked(std::move(wave), 3, 2);
        scenes.push_back(std::move(wave));
    }
    return scenes;
}

const BaselineScene* find_scene(const std::vector<BaselineScene>& scenes, const std::string& name)
{
    const auto found = std::find_if(scenes.begin(), scenes.end(),
        [&](const BaselineScene& scene) { return scene.name == name && scene.scene; });
    return found == scenes.end() ? nullptr : &*found;
}

} // namespace firsthit::cli::bench
