// items_bench.cpp - item buffer and hits, without shading, against Embree's refit and 8-wide
// coherent primary rays: same process, frame by frame in turn, medians.
//
//     items_bench [--threads N] [--rounds N] [SCENE[@SECONDS] ...]
//
// Both sides are given the posed world and leave triangle id, depth and barycentrics of 1024x1024
// samples. Ours starts from world positions; Embree is given eye-space corners, so that it does not
// pay for the camera transform.
#include "baselines.h"

#include "base/stopwatch.h"
#include "base/tasks.h"
#include "cpu/frame.h"
#include "rays/embree_caster.h"
#include "render/check_settings.h"
#include "scene/animate/pose.h"
#include "scene/model/borrow.h"
#include "visibility/bin/project.h"

#include <firsthit/firsthit.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace firsthit {
namespace {

struct Options {
    int threads = 1;
    int rounds = 21;
    std::vector<std::string> scenes;
};

/// The frame without colour.
struct Ours {
    FrameMemory memory;
    Film film;
    Stats stats;
    Settings settings;
    std::vector<double> total_ms, setup_ms, raster_ms, resolve_ms;

    Ours()
    {
        settings.color = false;
        settings.aovs = {Aov::item, Aov::depth, Aov::barycentric};
    }

    void frame(const World& world, const View& view, Tasks& tasks)
    {
        stats = {};
        Stopwatch watch;
        render_frame({world, view, tasks, film}, settings, memory, stats);
        total_ms.push_back(watch.lap_ms());
        setup_ms.push_back(stats.setup_ms);
        raster_ms.push_back(stats.raster_ms);
        resolve_ms.push_back(stats.resolve_ms);
    }
};

struct Theirs {
    EmbreeCaster embree;
    std::vector<std::uint32_t> items;
    std::vector<float> t;
    std::vector<double> update_ms, cast_ms;

    Theirs(const EyeTriangles& triangles, const Pencil& pencil, int threads)
        : embree(triangles, false, true, threads),
          items(std::size_t(pencil.width) * std::size_t(pencil.height)),
          t(items.size())
    {
    }

    void frame(const EyeTriangles& triangles, const Pencil& pencil, Tasks& tasks)
    {
        Stopwatch watch;
        embree.refit(triangles);
        update_ms.push_back(watch.lap_ms());
        embree.cast(pencil, items, t, tasks);
        cast_ms.push_back(watch.lap_ms());
    }
};

void measure(const std::string& argument, const Options& options)
{
    const SceneArgument asked(argument);
    const Scene scene = load_scene(asked.scene);
    Tasks tasks(options.threads);
    World world;
    pose(borrow(scene), asked.time_s, world, tasks);
    View view;
    view.camera = world.camera;
    view = checked(view);

    ViewMemory eye;
    eye.pencil = pencil_of(view, view.region, 1);
    project_vertices(world.position, eye.pencil, eye, tasks);
    const EyeTriangles triangles{eye.corner.span().first(world.position.size()), scene.index};

    Ours ours;
    Theirs theirs(triangles, eye.pencil, options.threads);
    for (int round = 0; round < options.rounds + 2; ++round) {
        if (round == 2) // warm
            for (auto* times : {&ours.total_ms, &ours.setup_ms, &ours.raster_ms, &ours.resolve_ms,
                     &theirs.update_ms, &theirs.cast_ms})
                times->clear();
        ours.frame(world, view, tasks);
        theirs.frame(triangles, eye.pencil, tasks);
    }
    std::size_t differ = 0;
    for (std::size_t i = 0; i < theirs.items.size(); ++i)
        differ += theirs.items[i] != ours.film.item[i];
    const double total = median(ours.total_ms);
    const double baseline = median(theirs.update_ms) + median(theirs.cast_ms);
    std::printf("%-22s %9zu %8.2f %8.2f %8.2f %9.2f %9.2f %9.2f %8.2f %9zu\n", asked.name.c_str(),
        scene.triangle_count(), median(ours.setup_ms), median(ours.raster_ms),
        median(ours.resolve_ms), total, median(theirs.update_ms), median(theirs.cast_ms),
        baseline / total, differ);
    std::fflush(stdout);
}

} // namespace
} // namespace firsthit

int main(int count, char** words)
{
    firsthit::Options options;
    for (int k = 1; k < count; ++k) {
        const std::string word = words[k];
        if (word == "--threads" && k + 1 < count)
            options.threads = std::atoi(words[++k]);
        else if (word == "--rounds" && k + 1 < count)
            options.rounds = std::max(1, std::atoi(words[++k]));
        else
            options.scenes.push_back(word);
    }
    if (options.scenes.empty())
        options.scenes = {"builtin:torus", "builtin:robots@2.5", "builtin:wave?n=10000",
            "builtin:wave?n=100000", "builtin:wave?n=1000000", "builtin:wave?n=10000000"};
    std::printf("1024x1024, %d thread(s), %s, medians of %d, milliseconds\n", options.threads,
        firsthit::instruction_set().c_str(), options.rounds);
    std::printf("%-22s %9s %8s %8s %8s %9s %9s %9s %8s %9s\n", "scene", "triangles", "setup",
        "raster", "resolve", "ours", "update", "rays", "ratio", "differ");
    try {
        for (const std::string& scene : options.scenes) firsthit::measure(scene, options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "items_bench: %s\n", error.what());
        return 1;
    }
}
