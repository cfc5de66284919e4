// view_options.cpp - what `firsthit view` was asked for.
#include "view/view_options.h"

#include "common/add_parsed.h"
#include "common/usage.h"

#include <firsthit/file.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace firsthit::cli {
namespace {

constexpr const char* kViewExamples = R"(Examples:
  firsthit view bunny.stl
  firsthit view builtin:robots --engine hybrid --shadows map
  firsthit view walk.glb --size 1920x1080 --rate 30
  firsthit view builtin:robots --script actions.txt --screenshot window.png
  firsthit view builtin:robots --script actions.txt --no-window
  firsthit view walk.glb --serve
  firsthit view walk.glb --serve 127.0.0.1:8080

The window has a page of all keys: press ?. docs/view.md describes it, and the actions of scripts.
At rest the picture is the one that `firsthit render` makes with the same options, bit for bit.
--serve shows the same in a page for a browser, without a display or a GPU: it prints the page's
address, which holds a secret. Ctrl-C ends it.

Exit codes: 0 done, 1 failed (no display, a scene that cannot be read, an assertion of a script),
2 wrong usage.)";

double parse_fps_within(const std::string& text, double least)
{
    const double fps = parse_number(text);
    if (least <= fps && fps <= 1000) return fps;
    throw UsageError(
        fmt::format("'{}' is no number of frames a second from {} to 1000", text, least));
}

} // namespace

void add_view_options(CLI::App& app, ViewOptions& options)
{
    RenderOptions& picture = options.picture;
    const auto integer = [](int low, int high) {
        return [low, high](const std::string& text) { return parse_integer(text, low, high); };
    };
    add_scene_options(app, picture.scene);
    add_parsed(app, "--time", picture.frames.time_s, parse_number, "S",
        "Seconds; default the begin of the scene's animation");
    add_parsed(
        app, "--rate", options.rate,
        [](const std::string& text) { return parse_fps_within(text, 1); }, "N",
        "Frames a second to hold while something moves, by leaving out what is dear; default 60");
    add_parsed(
        app, "--fps-limit", options.fps_limit,
        [](const std::string& text) { return parse_fps_within(text, 0); }, "N",
        "Show at most so many frames a second; default 0: as many as the screen");
    app.add_option("--script", options.script, "Play the actions of a file (docs/view.md)")
        ->type_name("FILE");
    app.add_option("--screenshot", options.screenshot,
           "Write what the window shows at the end of the script, .png")
        ->type_name("FILE");
    add_parsed(app, "--serve", options.serve, view::parse_listen_address, "[ADDRESS:PORT]",
        "Show it in a page for a browser, without a display; default 127.0.0.1, a free port")
        ->expected(0, 1);
    app.add_flag("--no-window", options.no_window, "Play the script without a window or display");
    app.add_flag("--measure", options.measure,
        "At the end print frames a second and the time from input to the screen");
    add_camera_options(app, picture.camera);
    add_light_options(app, picture.light);
    add_sky_options(app, picture.sky);
    add_environment_options(app, picture.environment);
    add_picture_options(app, picture.picture);
    add_parsed(app, "--samples", picture.samples, integer(1, 16), "N",
        "N x N rays in every pixel, 1 to 16; default: see --aa");
    add_parsed(app, "--aa", picture.adaptive, integer(1, 16), "N",
        "N x N rays where a pixel may hold an edge, 1 to 16; default 4 for a picture at rest, 1: "
        "nowhere. Not for the gpu engine");
    add_parsed(app, "--engine", picture.engine.engine, parse_engine, "cpu|hybrid|gpu|auto",
        "Who makes the picture: cpu, exactly; hybrid, items and shadow maps by OpenGL and rays by "
        "the CPU; gpu, all by OpenGL; auto, gpu where OpenGL runs on hardware; default cpu");
    add_engine_options(app, picture.engine);
    add_parsed(app, "--threads", picture.threads, integer(0, 1024), "N",
        "Threads, 0 to 1024; default 0: one for each core");
    app.footer(kViewExamples);
}

void check(ViewOptions& options)
{
    // The picture at rest is what `render -o -` makes: colours, with smooth edges.
    options.picture.output = "-";
    if (options.picture.picture.format.empty()) options.picture.picture.format = ".png";
    options.size_given = options.picture.camera.size.has_value();
    if (!options.size_given) options.picture.camera.size = Size{1280, 720};
    check(options.picture);
    if (options.serve && (options.no_window || !options.script.empty()))
        throw UsageError("--serve shows a page: --script and --no-window go without it");
    if (options.no_window && options.script.empty())
        throw UsageError("--no-window plays a script: say --script FILE too");
    if (!options.screenshot.empty() && options.script.empty())
        throw UsageError("--screenshot is of the end of a script: say --script FILE too");
    if (!options.screenshot.empty()) check_output_path(options.screenshot);
}

} // namespace firsthit::cli
