// hybrid_bench.cpp - the hybrid engine's frames with synchronous and asynchronous readback: same
// process, in turn, medians.
//
//     hybrid_bench [--threads N] [--rounds N] [--size WIDTHxHEIGHT] [--shadows] [SCENE[@SECONDS] ...]
//
// The last column is the share of OpenGL's time, from the first call to the last item in host
// memory, that the rays did not have to wait for.
#include "peers.h"

#include <firsthit/firsthit.h>

#include <cstdio>
#include <cstdlib>
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
    Readback readback = Readback::async;
    int chunks = 1;
    std::vector<double> frame, draw, transfer, wait;
};

void measure(const std::string& argument, const Options& options)
{
    const SceneArgument asked(argument);
    const Scene scene = load_scene(asked.scene);
    Renderer renderer(options.threads);
    World world;
    renderer.pose(scene, asked.time_s, world);
    View view;
    view.width = options.width;
    view.height = options.height;
    view.camera = scene.camera ? world.camera : framing_camera(world);
    std::vector<Way> ways = {{Readback::sync, 1, {}, {}, {}, {}}};
    for (const int chunks : {1, 2, 4, 8, 16, 32})
        ways.push_back({Readback::async, chunks, {}, {}, {}, {}});
    Film film;
    for (int round = -2; round < options.rounds; ++round)
        for (std::size_t k = 0; k < ways.size(); ++k) {
            // Each round begins with another way.
            Way& way = ways[(k + std::size_t(round + 2)) % ways.size()];
            Settings settings;
            settings.engine = Engine::hybrid;
            settings.shadows = options.shadows ? Shadows::map : Shadows::none;
            settings.opengl.readback = way.readback;
            settings.opengl.readback_chunks = way.chunks;
            renderer.render(world, view, settings, film);
            if (round < 0) continue;
            const Stats& stats = renderer.stats();
            way.frame.push_back(stats.total_ms);
            way.draw.push_back(stats.draw_ms);
            way.transfer.push_back(stats.transfer_ms);
            way.wait.push_back(stats.wait_ms);
        }
    std::printf("%s: %zu triangles, %s\n", argument.c_str(), scene.triangle_count(),
        renderer.engine().device.c_str());
    std::printf("%-10s %9s %9s %9s %9s %9s\n", "readback", "frame ms", "draw", "transfer", "wait",
        "hidden");
    for (Way& way : ways) {
        const double draw = median(way.draw), transfer = median(way.transfer),
                     wait = median(way.wait);
        const std::string name = way.readback == Readback::sync
                                     ? std::string("sync")
                                     : "async " + std::to_string(way.chunks);
        std::printf("%-10s %9.2f %9.2f %9.2f %9.2f %8.0f%%\n", name.c_str(), median(way.frame),
            draw, transfer, wait, 100 * (1 - wait / (draw + transfer)));
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
