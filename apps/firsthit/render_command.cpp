// render_command.cpp - `firsthit render`: pictures of a scene.
#include "render_command.h"

#include "common/interrupt.h"
#include "common/output.h"
#include "common/progress.h"
#include "stats_report.h"
#include "common/stopwatch.h"
#include "common/usage.h"

#include <firsthit/file.h>

#include <fmt/format.h>

namespace firsthit::cli {

namespace {

void write_files(const RenderOptions& options, const Film& film, int frame)
{
    const HoldInterrupts hold;
    if (!options.output.empty()) write_color(film, file_name(options, options.output, frame));
    for (const AovOutput& aov : options.aovs)
        write_aov(film, aov.aov, file_name(options, aov.path, frame));
}

void report(const RenderOptions& options, const RunReport& run)
{
    if (options.stats) print(stats_table(run));
    if (options.stats_json.empty()) return;
    const std::string text = to_text(stats_json(run));
    const HoldInterrupts hold;
    if (options.stats_json == "-")
        print(text);
    else
        write_file(options.stats_json, text);
}

/// Says on standard error which engine `auto` became, where that is new.
void say_reason(const EngineInfo& info, std::string& said)
{
    if (info.reason.empty()) return;
    const std::string text =
        fmt::format("firsthit: engine {}: {}\n", engine_name(info.engine), info.reason);
    if (text != said) fmt::print(stderr, "{}", text);
    said = text;
}

} // namespace

int run_render(const RenderOptions& options)
{
    check(options);
    RunReport run;
    run.scene = options.scene.name;
    run.width = options.camera.size.width;
    run.height = options.camera.size.height;
    run.samples = options.samples;
    run.instruction_set = instruction_set();
    const Stopwatch loading;
    Scene read = load(options.scene);
    check_inputs_stay(options, read);
    apply(options.light, read);
    check_memory(options, read.lights.size());
    const auto scene = std::make_shared<const Scene>(std::move(read));
    run.load_ms = loading.ms();

    const std::vector<double> times =
        options.frames.empty() ? std::vector<double>{options.time_s.value_or(scene->begin_s)}
                               : options.frames;
    const Settings settings = render_settings(options);
    Renderer renderer(options.threads);
    run.threads = renderer.threads();
    ViewMaker views(options.camera);
    World world;
    Film film;
    std::string said;
    {
        Progress progress("frames", times.size());
        for (std::size_t frame = 0; frame < times.size(); ++frame) {
            const Stopwatch total;
            renderer.pose(scene, times[frame], world);
            renderer.render(world, views.view(world), settings, film);
            Stats stats = renderer.stats();
            say_reason(renderer.engine(), said);
            const Stopwatch writing;
            write_files(options, film, static_cast<int>(frame));
            stats.write_ms = writing.ms();
            stats.total_ms = total.ms();
            run.frames.push_back({times[frame], stats});
            progress.advance();
        }
    }
    run.engine = engine_name(renderer.engine().engine);
    run.device = renderer.engine().device;
    run.peak_memory_bytes = peak_memory_bytes();
    report(options, run);
    return kExitDone;
}

} // namespace firsthit::cli
