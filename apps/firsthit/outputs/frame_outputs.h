// frame_outputs.h - where the frames of `firsthit render` go: files for each, or a film.
#pragma once

#include "common/interrupt.h"
#include "films/film_writer.h"
#include "options/render_options.h"

#include <future>
#include <optional>
#include <vector>

namespace firsthit::cli {

/// Writes frames as they come. Each file appears whole or not at all; so does a film, which is there
/// after finish(). Signals that end the program wait until a frame's files are whole, or until the parts of a
/// film are gone.
///
/// Of several frames, each is written by a thread of its own while the next one is made: in order, and never more
/// than one at a time.
class FrameOutputs {
  public:
    /// Both have to outlive it.
    FrameOutputs(const RenderOptions& options, const Frames& frames);
    /// Waits for the frame that is being written.
    ~FrameOutputs();
    FrameOutputs(const FrameOutputs&) = delete;
    FrameOutputs& operator=(const FrameOutputs&) = delete;

    /// Whether all files of a frame are there already.
    /// frame  from 0
    bool are_there(std::size_t frame) const;

    /// Which frames are to be made: those of --only and --chunk but for, with --resume, those that are there.
    /// returns  (frames)
    std::vector<bool> to_make() const;

    /// Writes a frame, or begins to. Waits for the frame before.
    ///
    /// film    of the frame; of several frames it gets the memory of an earlier one in exchange
    /// throws  FileError, DeviceError: also of the frame before
    void write(Film& film, std::size_t frame);

    /// All files are there.
    /// throws  FileError, DeviceError
    void finish();

  private:
    void write_now(const Film& film, std::size_t frame);
    void wait();
    void add_to_film(const Film& film);
    PictureOptions how_to_write() const;

    const RenderOptions& options_;
    const Frames& frames_;
    std::optional<HoldInterrupts> hold_; // of a film, or of what is being written; outlives both
    std::optional<FilmWriter> film_;
    Film writing_;              // what the thread writes
    std::future<void> written_; // of that
};

} // namespace firsthit::cli
