// film_recorder.h - writes what is shown as a film, while it is shown.
#pragma once

#include "common/interrupt.h"
#include "films/film_writer.h"
#include "view/frames/frame_request.h"

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

namespace firsthit::cli::view {

/// A film at a constant rate: each of its frames is the picture that was shown at that time. A thread of its own
/// scales the pictures to the film's size and hands them to ffmpeg, so that nobody waits for it.
class FilmRecorder {
  public:
    static constexpr double kFps = 30;

    /// width, height  of the film in pixels
    /// throws  as FilmWriter: no ffmpeg, a folder that cannot be written
    FilmRecorder(const std::string& path, int width, int height);
    /// Finishes the film.
    ~FilmRecorder();
    FilmRecorder(const FilmRecorder&) = delete;
    FilmRecorder& operator=(const FilmRecorder&) = delete;

    /// What is on the screen from the last call until now.
    void show(const std::shared_ptr<const ShownFrame>& frame, Clock::time_point now);
    /// Nothing more comes. The film is finished on the thread.
    void stop();
    /// Whether stop() was called and the film is written, or has failed.
    bool is_done() const;
    /// What went wrong; empty: nothing.
    std::string error() const;

    const std::string& path() const { return path_; }
    double length_s() const { return double(asked_) / kFps; }

  private:
    struct Piece {
        std::shared_ptr<const ShownFrame> frame;
        std::size_t repeats = 0;
    };
    void run();

    std::string path_;
    int width_, height_;
    HoldInterrupts hold_; // a film's parts go before the program ends
    FilmWriter writer_;
    Clock::time_point begin_{};
    std::size_t asked_ = 0; // frames of the film until now
    mutable std::mutex mutex_;
    std::condition_variable wakes_;
    std::deque<Piece> pieces_;
    std::string error_;
    bool ends_ = false, done_ = false;
    std::thread thread_; // last: it uses all others
};

} // namespace firsthit::cli::view
