// render_command.cpp - `firsthit render`: pictures of a scene.
#include "render_command.h"

#include "common/interrupt.h"
#include "common/output.h"
#include "common/manifest.h"
#include "common/progress.h"
#include "common/verbosity.h"
#include "outputs/dry_run.h"
#include "outputs/frame_outputs.h"
#include "stats_report.h"
#include "common/stopwatch.h"
#include "inputs/ground_maker.h"
#include "inputs/scene_source.h"
#include "common/usage.h"

#include <firsthit/file.h>

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

namespace firsthit::cli {

namespace {

void print_report(const RenderOptions& options, const RunReport& run)
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

bool writes_standard_output(const RenderOptions& options)
{
    return options.output == "-" || std::any_of(options.aovs.begin(), options.aovs.end(),
                                        [](const AovOutput& aov) { return aov.path == "-"; });
}

/// Says that frames are alike where no clip and no shape moves.
void warn_if_still(const RenderOptions& options, const Scene& scene, std::size_t frames)
{
    if (!options.frames.several() || frames < 2 || options.camera.path ||
        options.camera.cameras.size() > 1 || !scene.clips.empty())
        return;
    for (const Instance& instance : scene.instances)
        if (instance.deform) return;
    print_warnings({fmt::format("{}: nothing moves in it, so that all frames are alike; "
                                "--turntable N goes round it",
        options.scene.shown_name())});
}

/// --aa that was asked for, of an engine that came to be chosen and does not know it.
void warn_if_not_smooth(const RenderOptions& options, const RunReport& run)
{
    if (options.adaptive.value_or(1) > 1 && run.engine == engine_name(Engine::gpu))
        print_warnings({"--aa: the gpu engine shoots one ray a pixel; accepted are --samples N, or "
                        "--engine cpu"});
}

/// A black picture should not leave its maker in the dark.
void warn_if_empty(const RenderOptions& options, const RunReport& run)
{
    if (run.engine != engine_name(Engine::cpu)) return; // only the cpu engine counts all hits
    for (const auto& frame : run.frames)
        if (frame.stats.hits > 0) return;
    print_warnings(
        {fmt::format("{}: nothing is seen in the picture: the camera looks past the scene; "
                     "--view iso shows all of it",
            options.scene.shown_name())});
}

/// The scene of a time. Of a sequence each may have files that no frame before it had.
void follow(SceneSource& source, const RenderOptions& options, double time_s,
    std::shared_ptr<const Scene>& scene)
{
    std::shared_ptr<const Scene> next = source.scene_at(time_s);
    if (next != scene) check_inputs_stay(options, *next);
    scene = std::move(next);
}

/// Whether a plane says what moved since the frame before.
bool wants_motion(const Settings& settings)
{
    return std::any_of(settings.aovs.begin(), settings.aovs.end(),
        [](Aov aov) { return aov == Aov::motion || aov == Aov::motion_visible; });
}

/// Takes what only the scene says: the size of pictures, and which planes there are.
void take_from_scene(const Scene& scene, RenderOptions& options)
{
    take_size(scene, options.camera);
    if (!options.data.planes && !options.data.exr.empty())
        options.data.planes = all_planes(scene.lights.size(), is_numbered(options));
}

/// --fps is of numbered scenes, of films and of frames that are counted.
void allow_fps_of_frames(RenderOptions& options)
{
    const bool counted = options.frames.clip || !options.frames.numbers.empty();
    options.scene.fps_of_frames = counted || is_film(options);
}

/// What is the same for all frames of a run.
struct RenderRun {
    const RenderOptions& options;
    const Frames& frames;
    SceneSource& source;
    ViewMaker& views;
    Renderer& renderer;
    PoseSettings pose;
    Settings settings;
};

/// wanted  how many frames are to be made
void say_what_is_left_out(const RenderOptions& options, const Frames& frames, std::size_t wanted)
{
    const std::vector<bool> part = frames_in_part(options.data.part, frames.number);
    const auto in_part = std::size_t(std::count(part.begin(), part.end(), true));
    if (options.data.part.any())
        print_detail(fmt::format("{} of {} frames are this run's", in_part, frames.size()));
    if (in_part > wanted)
        print_detail(fmt::format("{} of {} frames were there already", in_part - wanted, in_part));
}

/// Renders the frames one after the other and writes them. Frames that are not to be made are only posed where
/// others need that: the first one, which the camera frames, and one before a frame with motion.
void render_frames(RenderRun& run, std::shared_ptr<const Scene> scene, RunReport& report)
{
    const RenderOptions& options = run.options;
    const std::size_t count = run.frames.size();
    FrameOutputs files(options, run.frames);
    // Asked once: while this process is at work, others may make frames too.
    const std::vector<bool> to_make = files.to_make();
    const auto wanted = std::size_t(std::count(to_make.begin(), to_make.end(), true));
    say_what_is_left_out(options, run.frames, wanted);
    if (wanted == 0) return;
    World world, before; // of this frame, and of the one before where motion is asked for
    double before_s = 0;
    Film film;
    std::stop_source stop;
    FrameControl control;
    if (count > 1) { // files are whole, and the parts of a film gone, before the program ends
        control.stop = stop.get_token();
        control.progress = [&stop](double) {
            if (HoldInterrupts::is_pending()) stop.request_stop();
        };
    }
    const bool motion = wants_motion(run.settings);
    std::string said;
    Progress progress("frames", wanted);
    for (std::size_t frame = 0; frame < count; ++frame) {
        const Stopwatch total;
        const bool skip = !to_make[frame];
        const bool needed = frame == 0 || (motion && frame + 1 < count && to_make[frame + 1]);
        if (skip && !needed) continue;
        run.pose.time_s = run.frames.time_s[frame];
        follow(run.source, options, run.pose.time_s, scene);
        if (before.scene && before.scene != scene &&
            !run.source.sequence().same_triangles(before_s, run.pose.time_s))
            run.settings.previous = {};
        run.renderer.pose(scene, run.pose, world);
        const View view = run.views.view(world, frame);
        if (!skip) {
            run.renderer.render(world, view, run.settings, film, control);
            Stats stats = run.renderer.stats();
            say_reason(run.renderer.engine(), said);
            if (options.picture.backdrop.gradient)
                lay_over(film, *options.picture.backdrop.gradient, view.region.y, view.height);
            const Stopwatch writing;
            files.write(film, frame);
            stats.write_ms = writing.ms();
            stats.total_ms = total.ms();
            report.frames.push_back({run.pose.time_s, stats});
        }
        if (motion) {
            std::swap(world, before);
            run.settings.previous = {&before, view.camera};
            before_s = run.pose.time_s;
        }
        if (!skip) progress.advance();
    }
    files.finish();
}

void write_manifest(const RenderOptions& options, const Scene& scene)
{
    if (options.data.manifest.empty()) return;
    const HoldInterrupts hold;
    write_file(options.data.manifest, to_text(manifest_of_ids(scene)));
}

} // namespace

int run_render(const RenderOptions& given)
{
    RenderOptions options = given;
    read_files(options);
    turn_suns(
        options.camera.up_axis.value_or(usual_up_axis(options.scene.shown_name())), options.light);
    check(options);
    if (writes_standard_output(given) && isatty(STDOUT_FILENO))
        throw UsageError("standard output is a terminal: send the picture to a file or a program");
    RunReport report;
    report.scene = options.scene.shown_name();
    report.samples = options.samples.value_or(1);
    report.adaptive = adaptive_samples(options);
    report.instruction_set = instruction_set();
    const Stopwatch loading;
    allow_fps_of_frames(options);
    const bool has_lights = !options.light.lights.empty();
    std::optional<ViewMaker> views;
    GroundMaker ground(options, views);
    if (options.ground.wanted) ground.look_at_first_frame(scene_changes(options));
    SceneSource source(options.scene, [&, change = scene_changes(options)](Scene& scene) {
        change(scene);
        if (options.ground.wanted) ground.add(scene);
    });
    std::shared_ptr<const Scene> scene = source.first();
    take_from_scene(*scene, options);
    if (!views) views.emplace(options.camera, options.scene.shown_name());
    report.width = options.camera.pixels().width;
    report.height = options.camera.pixels().height;
    check_inputs_stay(options, *scene);
    check_memory(options, scene->lights.size());
    report.load_ms = loading.ms();
    print_detail(fmt::format("read {}: {} triangles, {:.0f} ms", options.scene.shown_name(),
        scene->triangle_count(), report.load_ms));

    const PoseSettings chosen = pose_settings(options.scene.pose, *scene);
    const Frames frames = frames_of(options, *scene, chosen);
    if (options.data.dry_run) {
        print(dry_run_text(options, *scene, frames));
        return kExitDone;
    }
    warn_if_still(options, *scene, frames.size());
    Renderer renderer(options.threads);
    report.threads = renderer.threads();
    RenderRun run{options, frames, source, *views, renderer, chosen, render_settings(options)};
    apply(options.sky, wants_studio(options.sky, *scene, has_lights), run.settings);
    render_frames(run, scene, report);
    write_manifest(options, *scene);
    report.engine = engine_name(renderer.engine().engine);
    report.device = renderer.engine().device;
    report.peak_memory_bytes = peak_memory_bytes();
    print_detail(
        fmt::format("engine {}, {} threads, {}; {:.0f} MB of memory at most", report.engine,
            report.threads, report.instruction_set, double(report.peak_memory_bytes) / 1e6));
    if (report.frames.empty()) {
        print_detail("nothing to do: no frame was left to make");
        return kExitNothingToDo;
    }
    warn_if_empty(options, report);
    warn_if_not_smooth(options, report);
    print_report(options, report);
    return kExitDone;
}

} // namespace firsthit::cli
