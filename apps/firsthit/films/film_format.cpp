// film_format.cpp - films by the endings of their names, and how ffmpeg is told to make them.
#include "films/film_format.h"

#include "inputs/frame_pattern.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

namespace firsthit::cli {
namespace {

std::string film_ending(const std::string& path)
{
    std::string ending = std::filesystem::path(path).extension().string();
    for (char& c : ending)
        if ('A' <= c && c <= 'Z') c = char(c - 'A' + 'a');
    return ending;
}

/// Half as many samples of colour as of light, of the colours of Rec.709.
constexpr const char* kVideoFilter =
    "crop=trunc(iw/2)*2:trunc(ih/2)*2:0:0,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p";

std::vector<std::string> video_words(const char* encoder, const char* quality)
{
    return {"-vf", kVideoFilter, "-c:v", encoder, "-crf", quality, "-colorspace", "bt709",
        "-color_primaries", "bt709", "-color_trc", "iec61966-2-1", "-color_range", "tv"};
}

std::vector<std::string> format_words(const std::string& ending)
{
    if (ending == ".gif") // a palette for each frame, so that no film is kept in memory
        return {"-filter_complex",
            "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1", "-loop", "0",
            "-f", "gif"};
    if (ending == ".webp")
        return {"-c:v", "libwebp_anim", "-quality", "90", "-loop", "0", "-f", "webp"};
    std::vector<std::string> words =
        ending == ".mp4" ? video_words("libx264", "17") : video_words("libvpx-vp9", "22");
    const std::vector<std::string> more =
        ending == ".mp4"
            ? std::vector<std::string>{"-preset", "medium", "-movflags", "+faststart", "-f", "mp4"}
            : std::vector<std::string>{
                  "-b:v", "0", "-row-mt", "1", "-deadline", "good", "-cpu-used", "4", "-f", "webm"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

} // namespace

bool is_film_path(const std::string& path, bool several_frames)
{
    if (looks_like_pattern(path)) return false;
    const std::string ending = film_ending(path);
    return ending == ".mp4" || ending == ".webm" || ending == ".gif" ||
           (ending == ".webp" && several_frames);
}

std::vector<std::string> ffmpeg_words(
    const std::string& path, const std::string& target, const FilmSize& size)
{
    std::vector<std::string> words = {"ffmpeg", "-hide_banner", "-loglevel", "error", "-nostats",
        "-y", "-f", "rawvideo", "-pixel_format", "rgb24", "-video_size",
        fmt::format("{}x{}", size.width, size.height), "-framerate",
        fmt::format("{:.9g}", size.fps), "-i", "pipe:0"};
    for (std::string& word : format_words(film_ending(path))) words.push_back(std::move(word));
    words.push_back("file:" + target);
    return words;
}

} // namespace firsthit::cli
