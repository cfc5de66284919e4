// film_format.h - films by the endings of their names, and how ffmpeg is told to make them.
#pragma once

#include <string>
#include <vector>

namespace firsthit::cli {

/// Whether a path is a film's: .mp4, .webm or .gif; .webp, which may be a picture, where there are
/// several frames. Numbered names are pictures.
bool is_film_path(const std::string& path, bool several_frames);

/// A film's picture and speed.
struct FilmSize {
    int width = 0;
    int height = 0;
    double fps = 24; // frames a second
};

/// The words with which ffmpeg reads rgb24 pictures from its standard input and writes a film. Sides of an
/// odd number of pixels lose one where the format has even ones only.
///
/// path    whose ending chooses the format
/// target  the file to write
std::vector<std::string> ffmpeg_words(
    const std::string& path, const std::string& target, const FilmSize& size);

} // namespace firsthit::cli
