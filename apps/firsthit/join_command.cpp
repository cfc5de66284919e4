// join_command.cpp - `firsthit join`: pictures of regions become the whole picture.
#include "join_command.h"

#include "common/add_parsed.h"
#include "common/interrupt.h"
#include "common/usage.h"
#include "common/verbosity.h"
#include "options/camera_options.h"

#include <firsthit/file.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace firsthit::cli {
namespace {

constexpr const char* kJoinExamples = R"(Examples:
  firsthit render builtin:room --size 1280x720 --region 0,0,1280,360 -o top.png
  firsthit render builtin:room --size 1280x720 --region 0,360,1280,360 -o bottom.png
  firsthit join 0,0,1280,360=top.png 0,360,1280,360=bottom.png -o room.png

Tiles are pictures or planes of one kind: .png of 8 or 16 bits, .exr with any channels, .npy. The values are those of
the tiles; the file has the same bytes as one that was rendered whole. Tiles that leave a pixel out, or have one
twice, are an error that names it. Exit codes: 0 done, 1 failed, 2 wrong usage.)";

/// throws  UsageError: the tiles reach to another size than --size
void check_join_size(const JoinOptions& options)
{
    if (!options.size) return;
    Size reached{0, 0};
    for (const PictureTile& tile : options.tiles) {
        reached.width = std::max(reached.width, tile.region.x + tile.region.width);
        reached.height = std::max(reached.height, tile.region.y + tile.region.height);
    }
    if (reached.width != options.size->width || reached.height != options.size->height)
        throw UsageError(fmt::format("--size {}x{}: the tiles reach to {}x{}", options.size->width,
            options.size->height, reached.width, reached.height));
}

} // namespace

PictureTile parse_tile(const std::string& text)
{
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals + 1 == text.size())
        throw UsageError(fmt::format("'{}' is no tile: accepted is x,y,width,height=FILE, with the "
                                     "region that the file was rendered with, as "
                                     "0,0,640,360=a.png",
            text));
    return {text.substr(equals + 1), parse_region(text.substr(0, equals))};
}

void add_join_options(CLI::App& app, JoinOptions& options)
{
    app.add_option_function<std::vector<std::string>>(
           "TILE",
           [&options](const std::vector<std::string>& texts) {
               for (const std::string& text : texts) options.tiles.push_back(parse_tile(text));
           },
           "A region as --region has it, and its file: x,y,width,height=FILE; two or more")
        ->required();
    app.add_option("-o,--output", options.output, "The whole picture, of the tiles' kind")
        ->type_name("FILE")
        ->required();
    add_parsed(app, "--size", options.size, parse_size, "WxH",
        "Pixels that the tiles have to cover; default as far as they reach");
    app.footer(kJoinExamples);
}

int run_join(const JoinOptions& options)
{
    check_join_size(options);
    std::vector<std::string> inputs;
    for (const PictureTile& tile : options.tiles) inputs.push_back(tile.path);
    const std::vector<std::string> outputs{options.output};
    check_output_path(options.output);
    check_inputs_stay(outputs, inputs);
    print_detail(fmt::format("joins {} tiles", options.tiles.size()));
    const HoldInterrupts hold;
    join_tiles(options.tiles, options.output);
    return kExitDone;
}

} // namespace firsthit::cli
