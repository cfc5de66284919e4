// dry_run.cpp - what `firsthit render --dry-run` says.
#include "outputs/dry_run.h"

#include "outputs/frame_outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace firsthit::cli {
namespace {

std::string plural(std::size_t count, const char* what)
{
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// "a_0000.png to a_0009.png (10 files)", or one name.
std::string files_text(const RenderOptions& options, const std::string& name, const Frames& frames)
{
    const std::string first = file_name(options, name, frames.number.front());
    const std::string last = file_name(options, name, frames.number.back());
    if (first == last) return first;
    return fmt::format("{} to {} ({} files)", first, last, frames.size());
}

} // namespace

std::string dry_run_text(const RenderOptions& options, const Scene& scene, const Frames& frames)
{
    std::string text;
    const auto line = [&](const char* name, const std::string& value) {
        fmt::format_to(std::back_inserter(text), "{:<9}{}\n", name, value);
    };
    const Size size = options.camera.pixels();
    const int samples = options.samples.value_or(1), adaptive = adaptive_samples(options);
    line("scene",
        fmt::format("{}: {}, {}, {}", options.scene.shown_name(),
            plural(scene.triangle_count(), "triangle"), plural(scene.instances.size(), "instance"),
            plural(scene.lights.size(), "light")));
    line("picture",
        fmt::format("{}x{} pixels, {} each{}, engine {}", size.width, size.height,
            plural(std::size_t(samples) * std::size_t(samples), "ray"),
            adaptive > 1 ? fmt::format(", {} at edges", adaptive * adaptive) : "",
            options.engine.engine == Engine::automatic ? "auto"
                                                       : engine_name(options.engine.engine)));
    std::string when =
        fmt::format("{} at {:.6g} s", plural(frames.size(), "frame"), frames.time_s[0]);
    if (frames.time_s.front() != frames.time_s.back())
        when = fmt::format("{}, {:.6g} s to {:.6g} s", plural(frames.size(), "frame"),
            frames.time_s.front(), frames.time_s.back());
    if (is_film(options)) when += fmt::format(", shown {:.6g} a second", frames.fps);
    line("frames", when);
    line("memory",
        fmt::format("{:.1f} MB of planes", double(film_bytes(options, scene.lights.size())) / 1e6));
    for (const std::string& name : outputs(options))
        line("file", files_text(options, name, frames));
    for (const std::string& name : {options.data.manifest, options.stats_json})
        if (!name.empty()) line("file", name);
    const std::vector<bool> part = frames_in_part(options.data.part, frames.number);
    const auto wanted = std::size_t(std::count(part.begin(), part.end(), true));
    if (options.data.part.any()) line("part", fmt::format("{} of them", plural(wanted, "frame")));
    if (options.data.resume) {
        const FrameOutputs files(options, frames);
        const std::vector<bool> left = files.to_make();
        const auto there = wanted - std::size_t(std::count(left.begin(), left.end(), true));
        line("resume", fmt::format("{} are there already, {} would be rendered",
                           plural(there, "frame"), wanted - there));
    }
    return text + "nothing was rendered (--dry-run)\n";
}

} // namespace firsthit::cli
