// item_repair_bench.cpp - what the repair of an item picture costs: medians over the whole picture,
// on one thread, beside the resolving of hits.
//
//     item_repair_bench [SCENE[@SECONDS] ...]
//
// The picture is the exact one, 1024x1024, with one pixel in a thousand shifted by one. The lazy
// exact pass is given 1,000 and 10,000 samples at random.
#include "base/stopwatch.h"
#include "base/tasks.h"
#include "hits/item_repair.h"
#include "hits/resolve_tile.h"
#include "render/check_settings.h"
#include "scene/model/borrow.h"
#include "visibility/bin/bin_triangles.h"
#include "visibility/lazy_items.h"
#include "visibility/bin/project.h"
#include "visibility/bin/view_memory.h"
#include "visibility/raster/raster_tile.h"

#include <firsthit/firsthit.h>

#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace firsthit {
namespace {

constexpr int kSide = 1024, kTile = 64, kRounds = 15;

template <class F>
double median_ms(const F& f)
{
    std::vector<double> ms;
    for (int round = 0; round < kRounds; ++round) {
        Stopwatch watch;
        f();
        ms.push_back(watch.lap_ms());
    }
    std::nth_element(ms.begin(), ms.begin() + kRounds / 2, ms.end());
    return ms[kRounds / 2];
}

/// A scene at a time, binned, with its items.
struct Frame {
    Tasks tasks{1};
    World world;
    Scene scene;
    ViewMemory view;
    TileItems tile;
    std::unique_ptr<RasterScratch> scratch = std::make_unique<RasterScratch>();
    HitMemory hits;
    std::vector<std::uint32_t> picture = std::vector<std::uint32_t>(kSide * kSide);
    std::vector<std::uint64_t> holes = std::vector<std::uint64_t>(kTile * kTile / kBlockSamples);

    explicit Frame(const std::string& name)
    {
        const std::size_t at = name.find('@');
        scene = load_scene(name.substr(0, at));
        pose(borrow(scene), at == std::string::npos ? 0 : std::atof(name.c_str() + at + 1), world);
        View camera;
        camera.width = camera.height = kSide;
        camera.camera = world.camera;
        const View filled = checked(camera);
        lay_out(pencil_of(filled, filled.region, 1), kTile, view);
        view.index = scene.index;
        project_vertices(world.position, view.pencil, view, tasks);
        bin_triangles(view, view, view, tasks);
        resize(*scratch, kTile);
        resize(tile, kTile);
        resize(hits, kTile, 1);
        for (int number = 0; number < view.tiles(); ++number) {
            raster_tile(view, view.rays(number), bin_of(view, std::size_t(number)), tile, *scratch);
            for (int y = 0; y < kTile; ++y)
                for (int x = 0; x < kTile; ++x) picture[at_of(number, x, y)] = item(x, y);
        }
    }

    std::size_t at_of(int number, int x, int y) const
    {
        return std::size_t((view.first_y(number) + y) * kSide + view.first_x(number) + x);
    }
    std::uint32_t item(int x, int y) const
    {
        return tile.item[std::size_t(tile_offset(x, y, kTile))];
    }

    void corrupt()
    {
        std::mt19937 random(1);
        for (std::size_t k = 1; k < picture.size(); ++k)
            if (random() % 1000 == 0) picture[k] = picture[k - 1];
    }

    /// Returns the number of holes.
    std::uint64_t repair(Multisample mode)
    {
        std::uint64_t count = 0;
        for (int number = 0; number < view.tiles(); ++number) {
            std::fill(holes.begin(), holes.end(), 0);
            repair_tile_items(view, {view, picture, number}, mode, tile, holes);
            for (const std::uint64_t word : holes) count += std::uint64_t(std::popcount(word));
        }
        return count;
    }
};

void measure(const std::string& name)
{
    Frame frame(name);
    std::printf("%s: %zu triangles\n", name.c_str(), frame.scene.index.size());
    double copy_ms = 0;
    const double resolve_ms = median_ms([&] {
        Stopwatch watch;
        copy_ms = 0;
        for (int number = 0; number < frame.view.tiles(); ++number) {
            watch.lap_ms();
            std::fill(frame.holes.begin(), frame.holes.end(), 0);
            repair_tile_items(frame.view, {frame.view, frame.picture, number}, Multisample::exact,
                frame.tile, frame.holes);
            copy_ms += watch.lap_ms();
            resolve_tile(frame.view, frame.view.pencil, frame.tile, frame.hits.of(0));
        }
    });
    std::printf("  %-12s %8.2f ms\n", "resolve", resolve_ms - copy_ms);
    frame.corrupt();
    constexpr std::pair<const char*, Multisample> kModes[] = {{"none", Multisample::none},
        {"lazy3", Multisample::lazy3}, {"lazy5", Multisample::lazy5}, {"full3", Multisample::full3},
        {"full5", Multisample::full5}, {"exact (copy)", Multisample::exact}};
    for (const auto& [mode_name, mode] : kModes) {
        std::uint64_t holes = 0;
        const double ms = median_ms([&] { holes = frame.repair(mode); });
        std::printf("  %-12s %8.2f ms %8zu holes\n", mode_name, ms, std::size_t(holes));
    }
    LazyMemory memory;
    for (const std::size_t count : {1000u, 10000u}) {
        std::mt19937 random(2);
        std::vector<ListedSample> samples(count);
        for (ListedSample& s : samples)
            s = {std::uint16_t(random() % kSide), std::uint16_t(random() % kSide)};
        const double ms = median_ms([&] {
            find_listed_items(frame.view.pencil, frame.view, {samples}, memory, frame.tasks);
        });
        std::printf("  lazy items of %zu samples %8.2f ms\n", count, ms);
    }
}

} // namespace
} // namespace firsthit

int main(int argc, char** argv)
{
    std::vector<std::string> scenes(argv + 1, argv + argc);
    if (scenes.empty()) scenes = {"builtin:robots@2.5", "builtin:wave?n=70000"};
    for (const std::string& scene : scenes) firsthit::measure(scene);
}
