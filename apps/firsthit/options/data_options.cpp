// data_options.cpp - planes in one file, what their ids mean, and which frames are left out.
#include "options/data_options.h"

#include "common/add_parsed.h"
#include "common/usage.h"

#include <firsthit/error.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace firsthit::cli {
namespace {

Aov plane_from_name(const std::string& name)
{
    try {
        return aov_from_name(name);
    } catch (const ArgumentError& error) {
        throw UsageError(std::string(error.what()) + ", color, all");
    }
}

} // namespace

std::optional<PlaneChoice> parse_planes(const std::string& text)
{
    if (text == "all") return {};
    PlaneChoice choice;
    choice.color = false;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string name = text.substr(begin, end - begin);
        begin = end + 1;
        if (name == "color" || name == "colour") {
            choice.color = true;
            continue;
        }
        const Aov aov = plane_from_name(name);
        if (std::find(choice.aovs.begin(), choice.aovs.end(), aov) == choice.aovs.end())
            choice.aovs.push_back(aov);
    }
    return choice;
}

void add_data_options(CLI::App& app, DataOptions& options)
{
    CLI::Option* exr =
        app.add_option("--exr", options.exr,
               "One .exr file of the colours and all planes, as channels R, G, B, Z, N.X, ...")
            ->type_name("FILE");
    add_parsed(app, "--planes", options.planes, parse_planes, "NAME,...",
        "What --exr has: color and names of planes, with commas between; default all")
        ->needs(exr);
    app.add_option("--manifest", options.manifest,
           "What the ids of planes stand for, as JSON: instances, nodes and materials with their "
           "names, and a colour for each")
        ->type_name("FILE");
    add_frame_part_options(app, options.part);
    app.add_flag("--resume,--skip-existing", options.resume,
        "Leave frames out whose files are all there: goes on with what was interrupted");
    app.add_flag("--dry-run", options.dry_run, "Say what would be rendered, and render nothing");
}

PlaneChoice all_planes(std::size_t lights, bool several_frames)
{
    PlaneChoice choice;
    for (int k = 0; k < kAovCount; ++k) {
        const Aov aov = static_cast<Aov>(k);
        if (aov == Aov::lit && (lights == 0 || lights > kMaxLitLights)) continue;
        if ((aov == Aov::motion || aov == Aov::motion_visible) && !several_frames) continue;
        choice.aovs.push_back(aov);
    }
    return choice;
}

} // namespace firsthit::cli
