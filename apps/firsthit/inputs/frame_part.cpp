// frame_part.cpp - which frames of a run this process makes.
#include "inputs/frame_part.h"

#include "common/add_parsed.h"
#include "common/parse.h"
#include "common/usage.h"
#include "inputs/frame_choice.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace firsthit::cli {
namespace {

constexpr int kMostChunks = 1'000'000;

std::vector<int> parse_only(const std::string& text)
{
    const std::vector<int> numbers = parse_frame_numbers(text);
    if (numbers.empty())
        throw UsageError(fmt::format(
            "'{}' is no list of frames: accepted are numbers, as 7, 40-59, 0-100/10 or 40-59,70",
            text));
    return numbers;
}

} // namespace

Chunk parse_chunk(const std::string& text)
{
    const std::size_t slash = text.find('/');
    try {
        if (slash != std::string::npos) {
            const int count = parse_integer(text.substr(slash + 1), 1, kMostChunks);
            return {parse_integer(text.substr(0, slash), 1, count), count};
        }
    } catch (const UsageError&) {
        // said below
    }
    throw UsageError(fmt::format(
        "'{}' is no chunk: accepted is I/N, the I-th of N, as 3/10, with I from 1 to N", text));
}

void add_frame_part_options(CLI::App& app, FramePart& part)
{
    add_parsed(app, "--only", part.only, parse_only, "N-M,...",
        "Of the frames that --frames or --turntable chose, those with these numbers; each has the "
        "time and camera that it has among all");
    add_parsed(app, "--chunk", part.chunk, parse_chunk, "I/N",
        "Of the frames, or of those that --only leaves, the I-th of N runs of equal length, I from "
        "1 to N: for N machines");
}

std::vector<bool> frames_in_part(const FramePart& part, const std::vector<int>& number)
{
    std::vector<std::size_t> chosen;
    for (std::size_t frame = 0; frame < number.size(); ++frame)
        if (part.only.empty() ||
            std::binary_search(part.only.begin(), part.only.end(), number[frame]))
            chosen.push_back(frame);
    const Chunk chunk = part.chunk.value_or(Chunk());
    const auto bound = [&](int chunks) {
        return static_cast<std::size_t>(
            std::uint64_t(chunks) * chosen.size() / std::uint64_t(chunk.count));
    };
    std::vector<bool> in_part(number.size(), false);
    for (std::size_t k = bound(chunk.number - 1); k < bound(chunk.number); ++k)
        in_part[chosen[k]] = true;
    return in_part;
}

} // namespace firsthit::cli
