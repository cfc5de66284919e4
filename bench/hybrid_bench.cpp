// hybrid_bench.cpp - the hybrid engine's frames of an animation with synchronous and asynchronous
// readback: same process, in turn, medians.
//
//     hybrid_bench [--threads N] [--rounds N] [--size WIDTHxHEIGHT] [--shadows] [SCENE[@SECONDS] ...]
//
// The last column is the share of OpenGL's time, from the first call to the last item in host
// memory, that the rays did not have to wait for.
#include "baselines.h"
#include "scene/model/borrow.h"

#include <firsthit/firsthit.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

namespace firsthit {
namespace {

struct Options {
    int threads = 0;
    int rounds = 41;
    int width = 1024, height = 1024;
    bool shadows = false;
    std::vector<std::string> scenes;
};

/// A way to read back, and what it took.
struct Way {
    Way(Readback how, int count, int threads)
        : readback(how),
          chunks(count),
          renderer(std::make_unique<Renderer>(threads))
    {
    }

    Readback readback;
    int chunks;
    std::unique_ptr<Renderer> renderer; // of its own: each sees all of the animation
    Film film;
    std::vector<double> frame, draw, transfer, wait, shadow;
};

void measure(const std::string& argument, const Options& options)
{
    const SceneArgument asked(argument);
    const Scene scene = load_scene(asked.scene);
    World world;
    View view;
    view.width = options.width;
    view.height = options.height;
    std::vector<Way> ways;
    ways.emplace_back(Readback::sync, 1, options.threads);
    for (const int chunks : {1, 2, 4, 8, 16, 32})
        ways.emplace_back(Readback::async, chunks, options.threads);
    for (int round = -3; round < options.rounds; ++round) {
        pose(borrow(scene), asked.time_s + 0.02 * (round + 3), world);
        view.camera = world.camera;
        for (std::size_t k = 0; k < ways.size(); ++k) {
            // Each round begins with another way.
            Way& way = ways[(k + std::size_t(round + 3)) % ways.size()];
            Settings settings;
            settings.engine = Engine::hybrid;
            settings.shadows = options.shadows ? Shadows::map : Shadows::none;
            settings.opengl.readback = way.readback;
            settings.opengl.readback_chunks = way.chunks;
            way.renderer->render(world, view, settings, way.film);
            if (round < 0) continue; // shaders are compiled, memory grows
            const Stats& stats = way.renderer->stats();
            way.frame.push_back(stats.total_ms);
            way.draw.push_back(stats.draw_ms);
            way.transfer.push_back(stats.transfer_ms);
            way.wait.push_back(stats.wait_ms);
            way.shadow.push_back(stats.shadow_ms);
        }
    }
    std::printf("%s: %zu triangles, %s\n", argument.c_str(), scene.triangle_count(),
        ways[0].renderer->engine().device.c_str());
    std::printf("%-10s %9s %9s %9s %9s %9s %9s\n", "readback", "frame ms", "draw", "transfer",
        "wait", "hidden", "shadow");
    for (Way& way : ways) {
        const double draw = median(way.draw), transfer = median(way.transfer),
                     wait = median(way.wait);
        const std::string name = way.readback == Readback::sync
                                     ? std::string("sync")
                                     : "async " + std::to_string(way.chunks);
        std::printf("%-10s %9.2f %9.2f %9.2f %9.2f %8.0f%% %9.2f\n", name.c_str(),
            median(way.frame), draw, transfer, wait, 100 * (1 - wait / (draw + transfer)),
            median(way.shadow));
    }
}

} // namespace
} // namespace firsthit

int main(int argc, char** argv)
{
    firsthit::Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const auto value = [&] { return ++i < argc ? std::string(argv[i]) : std::string(); };
        if (word == "--threads")
            options.threads = std::atoi(value().c_str());
        else if (word == "--rounds")
            options.rounds = std::atoi(value().c_str());
        else if (word == "--size")
            std::sscanf(value().c_str(), "%dx%d", &options.width, &options.height);
        else if (word == "--shadows")
            options.shadows = true;
        else if (word.starts_with("--")) {
            std::fprintf(stderr, "hybrid_bench: %s is not understood\n", word.c_str());
            return 2;
        } else
            options.scenes.push_back(word);
    }
    if (options.scenes.empty()) options.scenes = {"builtin:torus", "builtin:robots@2.5"};
    try {
        for (const std::string& scene : options.scenes) firsthit::measure(scene, options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "hybrid_bench: %s\n", error.what());
        return 1;
    }
    return 0;
}
