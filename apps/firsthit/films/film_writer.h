// film_writer.h - a film, made by ffmpeg, that appears whole or not at all.
#pragma once

#include "films/fed_process.h"
#include "films/film_format.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace firsthit::cli {

/// Checks, before anything is rendered, whether a film can be written.
/// throws  DeviceError: ffmpeg is not installed; the message says how to install it
///         FileError: as check_output_path
void check_film(const std::string& path);

/// Hands frames to ffmpeg, which writes beside `path` under a temporary name.
class FilmWriter {
  public:
    /// throws  as check_film; UsageError: a picture that is too small for the format
    FilmWriter(const std::string& path, const FilmSize& size);
    /// Without finish(), nothing is left.
    ~FilmWriter();
    FilmWriter(const FilmWriter&) = delete;
    FilmWriter& operator=(const FilmWriter&) = delete;

    /// The next frame.
    /// pixels  (height, width, 3) 8-bit sRGB
    /// throws  FileError: ffmpeg failed or was ended; with its last words
    void add(std::span<const std::uint8_t> pixels);

    /// The film is whole.
    /// throws  as add
    void finish();

  private:
    [[noreturn]] void fail(const std::string& why);

    std::string path_;      // as given, for messages
    std::string target_;    // where it goes, links resolved
    std::string temporary_; // empty where nothing is left to remove
    std::optional<FedProcess> ffmpeg_;
};

} // namespace firsthit::cli
