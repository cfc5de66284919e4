// shadow_bench.cpp - shadows of one frame, exact and by maps, against Embree's 8-wide coherent
// shadow rays for the same points: same process, in turn, medians.
//
//     shadow_bench [--threads N] [--rounds N] [--size WIDTHxHEIGHT] [--lights N] [--map-size N]
//         [SCENE[@SECONDS] ...]
//
// Embree's tree is built beforehand and not counted. Both sides are given only the hits whose
// surface faces the light; Embree is given their points in the light's space, 4x2 pixels a packet.
// Of several lights (around the first), Embree is measured for the first only. A map is made anew
// in every round. Its wrong pixels are counted against the exact pass.
#include "embree_tree.h"
#include "baselines.h"

#include "base/stopwatch.h"
#include "base/tasks.h"
#include "cpu/frame.h"
#include "render/check_settings.h"
#include "scene/animate/pose.h"
#include "scene/model/borrow.h"
#include "shadow/exact/collect_hits.h"
#include "shadow/exact/find_receivers.h"
#include "shadow/map/sample_shadow_map.h"

#include <firsthit/firsthit.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

namespace firsthit {
namespace {

struct Options {
    int threads = 1;
    int rounds = 11;
    int width = 1024, height = 1024;
    int lights = 1;
    int map_size = 0;
    std::vector<std::string> scenes;
};

/// The first light, and others around it.
void set_lights(int count, World& world)
{
    world.lights.resize(1);
    const glm::dvec3 at = world.lights[0].position;
    const double distance = std::sqrt(at.x * at.x + at.y * at.y + at.z * at.z);
    for (int k = 1; k < count; ++k) {
        Light light = world.lights[0];
        light.position.x += 0.5 * distance * std::cos(2.4 * k);
        light.position.z += 0.5 * distance * std::sin(2.4 * k);
        world.lights.push_back(light);
    }
}

struct Times {
    std::vector<double> collect, project, sort, test, exact, map, embree;
};

/// Makes the maps as if everything had moved, and asks them for all hits.
void run_maps(const World& world, const Settings& settings, std::span<const HitTile> tiles,
    ShadowMaps& maps, Tasks& tasks, Buffer<float>& lit)
{
    maps.geometry.position.resize(0);
    start_maps(world, tasks.threads(), maps);
    tasks.for_each(
        tiles.size(), [&](std::size_t k, std::size_t worker) { add_hits(tiles[k], maps, worker); });
    update_maps(world, settings, maps, tasks);
    const std::size_t samples = lit.size() / tiles.size();
    for (std::size_t light = 0; light < world.lights.size(); ++light)
        tasks.for_each(tiles.size(), [&](std::size_t k, std::size_t) {
            sample_shadow_map(maps, world, tiles[k], light, lit.data() + k * samples);
        });
}

/// Hits whose light by the map is not that of the exact pass (of the last light).
std::size_t count_wrong(
    std::span<const HitTile> tiles, const LightVisibilityBits& bits, const Buffer<float>& lit)
{
    std::size_t wrong = 0;
    const std::size_t samples = lit.size() / tiles.size();
    for (std::size_t tile = 0; tile < tiles.size(); ++tile)
        for (const HitRun& run : tiles[tile].runs)
            for (std::uint64_t rest = run.samples; rest; rest &= rest - 1) {
                const std::size_t bit = std::size_t(std::countr_zero(rest));
                const bool exact =
                    bits.words[bits.first_word(bits.lights - 1, tile) + run.block] >> bit & 1;
                wrong += exact != (lit[tile * samples + run.block * 64u + bit] > 0.5f);
            }
    return wrong;
}

void measure(const std::string& argument, const Options& options)
{
    const SceneArgument asked(argument);
    const Scene scene = load_scene(asked.scene);
    Tasks tasks(options.threads);
    World world;
    pose(borrow(scene), asked.time_s, world, tasks);
    set_lights(options.lights, world);
    View view;
    view.width = options.width;
    view.height = options.height;
    view.camera = world.camera;
    view = checked(view);

    FrameMemory memory;
    Film film;
    Stats stats;
    Settings settings;
    settings.shadow_map_size = options.map_size;
    render_frame({world, view, tasks, film}, settings, memory, stats);
    const std::size_t samples = std::size_t(memory.tiles[0].size * memory.tiles[0].size);
    const auto run_exact = [&] {
        test_exact_shadows(
            {world, view.camera.eye, memory.tiles}, memory.lit.exact, tasks, memory.lit.bits);
    };

    // The points of all tiles and the first light, for Embree.
    PencilMesh mesh;
    const PencilSpace space = light_space(world.lights[0], view.camera.eye);
    make_pencil_mesh(space, world.position, scene.index, mesh, tasks);
    const EmbreeTree tree(mesh, options.threads);
    std::vector<std::unique_ptr<PointChunk>> chunks;
    std::vector<std::uint8_t> theirs(memory.tiles.size() * samples);
    TileReceivers receivers;
    for (std::size_t tile = 0; tile < memory.tiles.size(); ++tile) {
        chunks.push_back(std::make_unique<PointChunk>());
        chunks.back()->reserve(samples);
        std::vector<std::uint64_t> chosen(samples / 64);
        find_receivers(mesh, memory.tiles[tile], receivers);
        collect_points(
            {memory.tiles[tile], receivers.runs(), mesh, nullptr, std::uint32_t(tile * samples)},
            chosen, *chunks.back());
    }

    Times times;
    ShadowEffort effort;
    ShadowMaps maps;
    Buffer<float> lit;
    lit.resize(memory.tiles.size() * samples);
    for (int round = 0; round < options.rounds + 2; ++round) {
        if (round == 2) times = {}; // warm
        take_effort(memory.lit.exact);
        Stopwatch watch;
        run_exact();
        times.exact.push_back(watch.lap_ms());
        effort = take_effort(memory.lit.exact);
        times.collect.push_back(effort.collect_ms);
        times.project.push_back(effort.project_ms);
        times.sort.push_back(effort.sort_ms);
        times.test.push_back(effort.test_ms);
        watch.lap_ms();
        run_maps(world, settings, memory.tiles, maps, tasks, lit);
        times.map.push_back(watch.lap_ms());
        std::fill(theirs.begin(), theirs.end(), std::uint8_t(0));
        watch.lap_ms();
        tasks.for_each(chunks.size(), [&](std::size_t tile, std::size_t) {
            tree.test(*chunks[tile], nullptr, theirs.data());
        });
        times.embree.push_back(watch.lap_ms());
    }
    std::size_t differ = 0;
    if (options.lights == 1)
        for (std::size_t k = 0; k < theirs.size(); ++k)
            differ += theirs[k] != memory.lit.exact.shadowed[k];
    const double exact = median(times.exact), map = median(times.map),
                 embree = median(times.embree);
    const double wrong = 100.0 * double(count_wrong(memory.tiles, memory.lit.bits, lit)) /
                         (double(view.width) * view.height);
    std::printf("%-22s %9zu %9zu %7.2f %6.2f %6.2f %7.2f %8.2f %8.2f %8.2f %6.2f %6.2f %7zu "
                "%7.2f%% %9zu %10zu %7zu\n",
        asked.name.c_str(), scene.triangle_count(), std::size_t(effort.points),
        median(times.collect), median(times.project), median(times.sort), median(times.test), exact,
        map, embree, embree / exact, embree / map, differ, wrong,
        std::size_t(effort.counts.triangles), std::size_t(effort.counts.pairs),
        std::size_t(effort.counts.uncertain));
    std::fflush(stdout);
}

} // namespace
} // namespace firsthit

int main(int count, char** words)
{
    firsthit::Options options;
    for (int k = 1; k < count; ++k) {
        const std::string word = words[k];
        if (word.rfind("--", 0) != 0) {
            options.scenes.push_back(word);
            continue;
        }
        const char* value = k + 1 < count ? words[++k] : "";
        if (word == "--threads")
            options.threads = std::atoi(value);
        else if (word == "--rounds")
            options.rounds = std::max(1, std::atoi(value));
        else if (word == "--lights")
            options.lights = std::max(1, std::atoi(value));
        else if (word == "--map-size")
            options.map_size = std::atoi(value);
        else if (word != "--size" ||
                 std::sscanf(value, "%dx%d", &options.width, &options.height) != 2) {
            std::fprintf(stderr, "shadow_bench: %s is not understood\n", word.c_str());
            return 2;
        }
    }
    if (options.scenes.empty())
        options.scenes = {"builtin:torus", "builtin:robots@2.5", "builtin:wave?n=10000",
            "builtin:wave?n=100000", "builtin:wave?n=1000000", "builtin:wave?n=10000000"};
    std::printf("%dx%d, %d light(s), %d thread(s), %s, medians of %d, milliseconds\n",
        options.width, options.height, options.lights, options.threads,
        firsthit::instruction_set().c_str(), options.rounds);
    std::printf("%-22s %9s %9s %7s %6s %6s %7s %8s %8s %8s %6s %6s %7s %8s %9s %10s %7s\n", "scene",
        "triangles", "points", "collect", "project", "sort", "test", "exact", "map", "Embree",
        "exact", "map", "differ", "map off", "set up", "pairs", "open");
    try {
        for (const std::string& scene : options.scenes) firsthit::measure(scene, options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "shadow_bench: %s\n", error.what());
        return 1;
    }
}
