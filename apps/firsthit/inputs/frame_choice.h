// frame_choice.h - which frames: --frames as times, as numbers, or the whole clip.
#pragma once

#include <firsthit/scene.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace firsthit::cli {

inline constexpr double kUsualFps = 24; // frames a second where nothing says another number

/// What --time and --frames said.
struct FrameChoice {
    std::optional<double> time_s; // --time; none: the clip's begin
    std::vector<double> times;    // "A:B:N"
    std::vector<int> numbers;     // "10-20" and so on, ascending
    bool clip = false;            // "clip"

    /// Whether --frames was given.
    bool several() const { return clip || !times.empty() || !numbers.empty(); }
};

/// The frames of one run, in order.
struct Frames {
    std::vector<double> time_s; // of the scene
    std::vector<int> number;    // in names of files
    double fps = kUsualFps;     // frames a second at which they show the scene as fast as it is

    std::size_t size() const { return time_s.size(); }
};

/// "A:B:N" (parse_frames), "clip", or numbers of frames: "7", "10-20", "0-100/10", also several with
/// commas between. throws  UsageError
FrameChoice parse_frame_choice(const std::string& text);

/// Numbers of frames, sorted, each once, as parse_frame_choice takes them. Empty: the text is no such list.
std::vector<int> parse_frame_numbers(std::string_view text);

/// --time, --frames. The two exclude each other.
/// returns  the option --frames, for others to exclude
CLI::Option* add_frame_choice(CLI::App& app, FrameChoice& choice);

/// The frames that were chosen, of a clip of a scene. A clip without --fps has as many frames as its file
/// asks for. Frame n is at n / fps seconds from the clip's begin; `clip` is all from its begin to its
/// end. Without --frames one frame, at --time.
///
/// fps     --fps, where it was given
/// throws  UsageError: more than a million frames
Frames frames_of(const FrameChoice& choice, const Scene& scene, const PoseSettings& pose,
    const std::optional<double>& fps);

} // namespace firsthit::cli
