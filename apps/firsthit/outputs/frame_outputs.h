// frame_outputs.h - where the frames of `firsthit render` go: files for each, or a film.
#pragma once

#include "common/interrupt.h"
#include "films/film_writer.h"
#include "options/render_options.h"

#include <optional>
#include <vector>

namespace firsthit::cli {

/// Writes frames as they come. Each file appears whole or not at all; so does a film, which is there
/// after finish(). While a film is made, signals that end the program wait until its parts are gone.
class FrameOutputs {
  public:
    /// Both have to outlive it.
    FrameOutputs(const RenderOptions& options, const Frames& frames);

    /// Whether all files of a frame are there already.
    /// frame  from 0
    bool are_there(std::size_t frame) const;

    /// Which frames are to be made: those of --only and --chunk but for, with --resume, those that are there.
    /// returns  (frames)
    std::vector<bool> to_make() const;

    /// throws  FileError, DeviceError
    void write(const Film& film, std::size_t frame);

    /// throws  FileError, DeviceError
    void finish();

  private:
    void add_to_film(const Film& film);
    PictureOptions how_to_write() const;

    const RenderOptions& options_;
    const Frames& frames_;
    std::optional<HoldInterrupts> hold_; // of a film; outlives it
    std::optional<FilmWriter> film_;
};

} // namespace firsthit::cli
