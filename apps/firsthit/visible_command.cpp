// visible_command.cpp - `firsthit visible`: which triangles are seen, and by how many pixels.
#include "visible_command.h"

#include "common/add_parsed.h"
#include "common/interrupt.h"
#include "common/json.h"
#include "common/output.h"
#include "common/progress.h"
#include "common/usage.h"
#include "inputs/scene_source.h"

#include <firsthit/error.h>
#include <firsthit/file.h>
#include <firsthit/render.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <bit>
#include <filesystem>
#include <iterator>

namespace firsthit::cli {
namespace {

constexpr const char* kVisibleExamples = R"(Examples:
  firsthit visible builtin:robots > seen.csv
  firsthit visible part.stl --view top -o seen.json
  firsthit visible part.stl --turntable 72 -o pixels.npy
  firsthit visible town.glb --camera transforms.json -o seen.csv

Counts the pixels whose ray through their centre sees each triangle first; of several frames all
of their pixels together. Triangles are numbered as in the plane `item`, in file order.
  .csv   triangle,instance,pixels: a line for each triangle that is seen
  .json  {"frames", "pixels", "triangles", "seen", "visible": [{triangle, instance, pixels}, ...]}
  .npy   uint64 (triangles,): the pixels of every triangle, 0 where it is not seen
Exit codes: 0 done, 1 failed, 2 wrong usage.)";

std::string parse_seen_format(const std::string& text)
{
    if (text == "csv" || text == "json" || text == "npy") return text;
    throw UsageError(fmt::format("'{}' is no format: accepted are csv, json and npy", text));
}

std::string seen_format(const VisibleOptions& options)
{
    if (!options.format.empty()) return options.format;
    if (options.output.empty() || options.output == "-") return "csv";
    const std::string ending = std::filesystem::path(options.output).extension().string();
    if (ending == ".csv" || ending == ".json" || ending == ".npy") return ending.substr(1);
    throw UsageError(fmt::format(
        "{}: unknown ending '{}': accepted are .csv, .json and .npy, or --output-format",
        options.output, ending));
}

/// What was counted.
struct SeenCount {
    std::vector<std::uint64_t> pixels; // (triangles)
    std::shared_ptr<const Scene> scene;
    std::uint64_t frames = 0;
    std::uint64_t all_pixels = 0; // of all frames, with those that see nothing
};

std::string seen_csv(const SeenCount& count)
{
    std::string text = "triangle,instance,pixels\n";
    for (const SeenTriangle& seen : seen_triangles(count.pixels, count.scene->owner))
        fmt::format_to(
            std::back_inserter(text), "{},{},{}\n", seen.triangle, seen.instance, seen.pixels);
    return text;
}

std::string seen_json(const SeenCount& count)
{
    const std::vector<SeenTriangle> all = seen_triangles(count.pixels, count.scene->owner);
    std::string text = fmt::format("{{\n \"frames\": {},\n \"pixels\": {},\n \"triangles\": {},\n "
                                   "\"seen\": {},\n \"visible\": [",
        count.frames, count.all_pixels, count.pixels.size(), all.size());
    const char* separator = "\n  ";
    for (const SeenTriangle& seen : all) {
        fmt::format_to(std::back_inserter(text),
            "{}{{\"triangle\": {}, \"instance\": {}, \"pixels\": {}}}", separator, seen.triangle,
            seen.instance, seen.pixels);
        separator = ",\n  ";
    }
    return text + "]\n}\n";
}

/// NumPy's format 1.0: its head fills up a multiple of 64 bytes.
std::string seen_npy(const SeenCount& count)
{
    static_assert(std::endian::native == std::endian::little);
    std::string head = fmt::format(
        "{{'descr': '<u8', 'fortran_order': False, 'shape': ({},), }}", count.pixels.size());
    constexpr std::size_t kBefore = 10; // bytes: magic, version, length
    head += std::string((64 - (kBefore + head.size() + 1) % 64) % 64, ' ') + '\n';
    std::string text = "\x93NUMPY";
    text += {'\x01', '\0', char(head.size() & 255), char(head.size() >> 8)};
    text += head;
    text.append(reinterpret_cast<const char*>(count.pixels.data()), 8 * count.pixels.size());
    return text;
}

SeenCount count_seen(const VisibleOptions& given)
{
    VisibleOptions options = given;
    read_files(options);
    options.scene.fps_of_frames = options.frames.clip || !options.frames.numbers.empty();
    SceneSource source(options.scene);
    SeenCount count;
    count.scene = source.first();
    take_size(*count.scene, options.camera);
    if (!options.output.empty() && options.output != "-")
        check_output_replaces_nothing(options, *count.scene, {options.output});
    count.pixels.resize(count.scene->triangle_count());
    PoseSettings chosen = pose_settings(options.scene.pose, *count.scene);
    const Frames frames = frames_of(options, options.frames, *count.scene, chosen);
    Renderer renderer(options.threads);
    ViewMaker views(options.camera, options.scene.name);
    Settings settings;
    settings.color = false;
    settings.aovs = {Aov::item};
    World world;
    Film film;
    Progress progress("frames", frames.size());
    for (std::size_t k = 0; k < frames.size(); ++k) {
        chosen.time_s = frames.time_s[k];
        const std::shared_ptr<const Scene> scene = source.scene_at(chosen.time_s);
        if (scene->triangle_count() != count.pixels.size())
            throw SceneError(fmt::format("{}: the frame at {:g} s has {} triangles, the first {}: "
                                         "count such frames one by one, with --time",
                options.scene.name, chosen.time_s, scene->triangle_count(), count.pixels.size()));
        renderer.pose(scene, chosen, world);
        renderer.render(world, views.view(world, k), settings, film);
        count_items(film.item, count.pixels);
        count.all_pixels += film.item.size();
        ++count.frames;
        progress.advance();
    }
    return count;
}

} // namespace

void count_items(std::span<const std::uint32_t> items, std::vector<std::uint64_t>& pixels)
{
    for (const std::uint32_t item : items)
        if (item != kNoItem) ++pixels[item];
}

std::vector<SeenTriangle> seen_triangles(
    const std::vector<std::uint64_t>& pixels, const std::vector<std::uint32_t>& owner)
{
    std::vector<SeenTriangle> all;
    for (std::uint32_t t = 0; t < pixels.size(); ++t)
        if (pixels[t] > 0) all.push_back({t, owner[t], pixels[t]});
    return all;
}

void add_visible_options(CLI::App& app, VisibleOptions& options)
{
    add_scene_options(app, options.scene);
    app.add_option("-o,--output", options.output,
           "A .csv, .json or .npy file; - or none is standard output, as CSV")
        ->type_name("FILE");
    add_parsed(app, "--output-format", options.format, parse_seen_format, "csv|json|npy",
        "The format, whatever the file is called");
    add_picture_set_options(app, options);
    app.footer(kVisibleExamples);
}

int run_visible(const VisibleOptions& options)
{
    const std::string format = seen_format(options);
    const bool to_stdout = options.output.empty() || options.output == "-";
    if (!to_stdout) check_output_path(options.output);
    const SeenCount count = count_seen(options);
    const std::string text = format == "csv"    ? seen_csv(count)
                             : format == "json" ? seen_json(count)
                                                : seen_npy(count);
    const HoldInterrupts hold;
    if (to_stdout)
        print(text);
    else
        write_file(options.output, text);
    return kExitDone;
}

} // namespace firsthit::cli
