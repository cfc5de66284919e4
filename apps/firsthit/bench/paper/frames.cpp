// frames.cpp - measures frames of the paper's scenes, way by way in turn.
#include "bench/paper/frames.h"
#include "bench/measure/one_light.h"

#include "bench/measure/in_turn.h"
#include "common/output.h"
#include "common/stopwatch.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace firsthit::cli::bench {

/// What a way keeps from frame to frame.
struct PaperRenderers::State {
    explicit State(int threads) : renderer(threads) {}

    Renderer renderer;
    World world;
    Film film;
};

namespace {

PaperScene loaded(const std::string& file, const std::string& note)
{
    Scene read = load_scene(file, kSmooth);
    print_warnings(read.warnings);
    leave_one_light(read);
    PaperScene scene{.file = file,
        .scene = std::make_shared<const Scene>(std::move(read)),
        .note = note,
        .camera = {}};
    World world;
    pose(scene.scene, scene.scene->begin_s(), world);
    scene.camera = framing_camera(world);
    return scene;
}

} // namespace

std::vector<PaperScene> paper_scenes(const BenchOptions& options)
{
    std::vector<PaperScene> scenes;
    scenes.push_back(loaded(robots_scene(options),
        options.bart.empty() ? "stands in for BART's Robot.aff, which --bart names"
                             : "BART's scene"));
    const std::string bunny = fetched_scene(options, "bunny.stl");
    if (bunny.empty())
        scenes.push_back({.file = "bunny.stl",
            .scene = {},
            .note = fmt::format("{} is missing: scripts/fetch_scenes.sh fetches it",
                (std::filesystem::path(options.scenes) / "bunny.stl").string()),
            .camera = {}});
    else
        scenes.push_back(loaded(bunny, "the Stanford bunny"));
    scenes.push_back(loaded("builtin:torus", "a simple scene"));
    return scenes;
}

View view_of(const PaperScene& scene, const World& world, const Size& size)
{
    return {.camera = !scene.scene->cameras.empty() ? world.camera : scene.camera,
        .width = size.width,
        .height = size.height,
        .region = {}};
}

double frame_time(const Scene& scene, int k, int count)
{
    return scene.begin_s() + (scene.end_s() - scene.begin_s()) * (k + 0.5) / count;
}

double median_of(const Frames& frames, double Stats::*member)
{
    std::vector<double> values;
    for (const Stats& stats : frames.stats) values.push_back(stats.*member);
    return quartiles(std::move(values)).median;
}

std::vector<double> item_buffer_ms(const Frames& frames)
{
    std::vector<double> ms;
    for (const Stats& stats : frames.stats) ms.push_back(stats.setup_ms + stats.raster_ms);
    return ms;
}

PaperRenderers::PaperRenderers(std::vector<Way> ways, int threads) : ways_(std::move(ways))
{
    for (std::size_t k = 0; k < ways_.size(); ++k)
        states_.push_back(std::make_unique<State>(threads));
}

PaperRenderers::~PaperRenderers() = default;

int PaperRenderers::threads() const
{
    return states_.front()->renderer.threads();
}

std::vector<Frames> PaperRenderers::measure(const PaperScene& scene, const Size& size, int rounds,
    int repeats, const std::function<void()>& done)
{
    std::vector<Frames> frames(ways_.size());
    std::vector<Contender> contenders;
    for (std::size_t way = 0; way < ways_.size(); ++way) {
        const auto frame = [&, way](int round) {
            State& state = *states_[way];
            const int k = round < 0 ? 0 : round % rounds;
            const Stopwatch watch;
            state.renderer.pose(scene.scene, frame_time(*scene.scene, k, rounds), state.world);
            state.renderer.render(
                state.world, view_of(scene, state.world, size), ways_[way].settings, state.film);
            const double ms = watch.ms();
            if (round >= 0) frames[way].stats.push_back(state.renderer.stats());
            return ms;
        };
        contenders.push_back({ways_[way].name, frame});
    }
    std::vector<Times> times = measure_in_turn(contenders, rounds * repeats, kWarmUp, done);
    for (std::size_t way = 0; way < ways_.size(); ++way) {
        frames[way].ms = std::move(times[way].ms);
        frames[way].failure = std::move(times[way].failure);
        if (!frames[way].failure.empty()) frames[way].stats.clear();
    }
    return frames;
}

} // namespace firsthit::cli::bench
