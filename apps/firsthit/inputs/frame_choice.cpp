// frame_choice.cpp - which frames: --frames as times, as numbers, or the whole clip.
#include "inputs/frame_choice.h"

#include "common/add_parsed.h"
#include "common/parse.h"
#include "common/usage.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <string_view>

namespace firsthit::cli {
namespace {

constexpr std::size_t kMostFrames = 1'000'000;
constexpr int kGreatestNumber = 999'999'999; // nine digits

/// Reads a whole number off the front of a text.
std::optional<int> take_number(std::string_view& text)
{
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || number < 0 || number > kGreatestNumber || text[0] == '-') return {};
    text.remove_prefix(std::size_t(end - text.data()));
    return number;
}

bool take(std::string_view& text, char c)
{
    if (text.empty() || text[0] != c) return false;
    text.remove_prefix(1);
    return true;
}

/// Adds the numbers of "7", "10-20" or "0-100/10". False: it is none of them, or too many.
bool add_numbers(std::string_view text, std::vector<int>& numbers)
{
    if (text.empty()) return false;
    const std::optional<int> first = take_number(text);
    std::optional<int> last = first, step = 1;
    if (take(text, '-')) {
        last = text.empty() ? std::nullopt : take_number(text);
        if (take(text, '/')) step = text.empty() ? std::nullopt : take_number(text);
    }
    if (!first || !last || !step || !text.empty() || *last < *first || *step < 1) return false;
    if (std::size_t(*last - *first) / std::size_t(*step) >= kMostFrames - numbers.size())
        return false;
    for (std::int64_t number = *first; number <= *last; number += *step)
        numbers.push_back(int(number));
    return true;
}

/// Frames a second of a clip that asks for a number of frames. A whole number, where the clip asks for so
/// many frames because their number was rounded.
double own_fps(int asked, double length_s)
{
    const double fps = (asked - 1) / length_s, whole = std::round(fps);
    return whole >= 1 && std::abs(whole - fps) * length_s <= 0.5 ? whole : fps;
}

/// All frames of the clip.
Frames whole_clip(const Scene& scene, const PoseSettings& pose, const std::optional<double>& fps)
{
    const double begin_s = scene.begin_s(pose.clip), end_s = scene.end_s(pose.clip);
    const double length_s = std::max(0.0, end_s - begin_s);
    Frames frames;
    const int asked = scene.frames(pose.clip);
    if (fps)
        frames.fps = *fps;
    else if (length_s > 0 && asked > 1)
        frames.fps = own_fps(asked, length_s);
    // What rounding takes from the last frame is given back.
    const double last = std::floor(length_s * frames.fps * (1 + 1e-12) + 1e-9);
    if (!(last < double(kMostFrames)))
        throw UsageError(fmt::format("--frames clip: {:g} s at {:g} frames a second are more than "
                                     "{} frames: choose a smaller --fps",
            length_s, frames.fps, kMostFrames));
    frames.number.resize(std::size_t(last) + 1);
    std::iota(frames.number.begin(), frames.number.end(), 0);
    for (const int number : frames.number)
        frames.time_s.push_back(std::min(end_s, begin_s + number / frames.fps));
    return frames;
}

} // namespace

std::vector<int> parse_frame_numbers(std::string_view text)
{
    std::vector<int> numbers;
    for (;;) {
        const std::size_t comma = text.find(',');
        if (!add_numbers(text.substr(0, comma), numbers)) return {};
        if (comma == std::string_view::npos) break;
        text.remove_prefix(comma + 1);
    }
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
}

FrameChoice parse_frame_choice(const std::string& text)
{
    FrameChoice choice;
    if (text == "clip")
        choice.clip = true;
    else if (text.find(':') != std::string::npos)
        choice.times = parse_frames(text);
    else
        choice.numbers = parse_frame_numbers(text);
    if (!choice.several())
        throw UsageError(
            fmt::format("'{}' is no choice of frames: accepted are FIRST:LAST:COUNT, two times in "
                        "seconds and 1 to {} frames, as 0:10:25; clip, all frames of the "
                        "animation; and numbers of frames, as 7, 10-20, 0-100/10 or 1,5,9",
                text, kMostFrames));
    return choice;
}

CLI::Option* add_frame_choice(CLI::App& app, FrameChoice& choice)
{
    CLI::Option* time = add_parsed(app, "--time", choice.time_s, parse_number, "S",
        "Seconds; default the begin of the scene's animation");
    const auto parse = [&choice](const std::string& text) {
        FrameChoice chosen = parse_frame_choice(text);
        chosen.time_s = choice.time_s;
        return chosen;
    };
    CLI::Option* frames = add_parsed(app, "--frames", choice, parse, "A:B:N|clip|N-M",
        "A:B:N: N frames from time A to time B, both included, numbered from 0. clip: all frames "
        "of "
        "the animation, --fps a second. 7, 10-20, 0-100/10 or 1,5,9: frames by their numbers, "
        "frame "
        "n at n / --fps seconds. Files need one %d, %4d or %04d, or are films");
    frames->excludes(time);
    return frames;
}

Frames frames_of(const FrameChoice& choice, const Scene& scene, const PoseSettings& pose,
    const std::optional<double>& fps)
{
    if (choice.clip) return whole_clip(scene, pose, fps);
    Frames frames;
    frames.fps = fps.value_or(kUsualFps);
    if (!choice.numbers.empty()) {
        frames.number = choice.numbers;
        const double begin_s = scene.begin_s(pose.clip);
        for (const int number : frames.number)
            frames.time_s.push_back(begin_s + number / frames.fps);
        return frames;
    }
    frames.time_s = choice.times;
    if (frames.time_s.empty()) frames.time_s = {choice.time_s.value_or(pose.time_s)};
    frames.number.resize(frames.size());
    std::iota(frames.number.begin(), frames.number.end(), 0);
    const double length_s = std::abs(frames.time_s.back() - frames.time_s.front());
    if (!fps && length_s > 0) frames.fps = double(frames.size() - 1) / length_s;
    return frames;
}

} // namespace firsthit::cli
