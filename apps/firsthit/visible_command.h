// visible_command.h - `firsthit visible`: which triangles are seen, and by how many pixels.
#pragma once

#include "options/picture_set_options.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace firsthit::cli {

struct VisibleOptions : PictureSetOptions {
    std::string output; // empty or "-": standard output
    std::string format; // "csv", "json" or "npy"; empty: by the output's ending, else csv
};

/// A triangle that is seen.
struct SeenTriangle {
    std::uint32_t triangle = 0;
    std::uint32_t instance = 0;
    std::uint64_t pixels = 0; // of all frames
    bool operator==(const SeenTriangle&) const = default;
};

/// Adds a picture's items to the pixels of each triangle.
/// pixels  (triangles)
void count_items(std::span<const std::uint32_t> items, std::vector<std::uint64_t>& pixels);

/// The triangles with pixels, by their number.
std::vector<SeenTriangle> seen_triangles(
    const std::vector<std::uint64_t>& pixels, const std::vector<std::uint32_t>& owner);

void add_visible_options(CLI::App& app, VisibleOptions& options);

/// returns  an exit code
int run_visible(const VisibleOptions& options);

} // namespace firsthit::cli
