// film_recorder.cpp - writes what is shown as a film, while it is shown.
#include "view/frames/film_recorder.h"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <utility>
#include <vector>

namespace firsthit::cli::view {
namespace {

/// Pictures that wait for ffmpeg. Where it is slower than the screen, some are left out and others shown longer.
constexpr std::size_t kMostPieces = 12;

/// A picture in another size, by the nearest pixels, without alpha.
void scale(const ShownFrame& frame, int width, int height, std::vector<std::uint8_t>& rgb)
{
    rgb.resize(std::size_t(width) * std::size_t(height) * 3);
    std::uint8_t* out = rgb.data();
    for (int y = 0; y < height; ++y) {
        const auto row = std::size_t(std::int64_t(y) * frame.height / height);
        for (int x = 0; x < width; ++x, out += 3) {
            const auto column = std::size_t(std::int64_t(x) * frame.width / width);
            const std::uint8_t* in = &frame.rgba[4 * (row * std::size_t(frame.width) + column)];
            std::copy_n(in, 3, out);
        }
    }
}

} // namespace

FilmRecorder::FilmRecorder(const std::string& path, int width, int height)
    : path_(path),
      width_(width),
      height_(height),
      writer_(path, FilmSize{width, height, kFps}),
      thread_([this] { run(); })
{
}

FilmRecorder::~FilmRecorder()
{
    stop();
    thread_.join();
}

void FilmRecorder::show(const std::shared_ptr<const ShownFrame>& frame, Clock::time_point now)
{
    if (!frame) return;
    if (begin_ == Clock::time_point{}) begin_ = now;
    const double passed_s = std::chrono::duration<double>(now - begin_).count();
    const auto due = std::size_t(std::max(0.0, passed_s) * kFps) + 1;
    if (due <= asked_) return;
    {
        const std::lock_guard lock(mutex_);
        if (ends_) return;
        const std::size_t repeats = due - asked_;
        if (pieces_.size() < kMostPieces)
            pieces_.push_back({frame, repeats});
        else
            pieces_.back().repeats += repeats;
    }
    asked_ = due;
    wakes_.notify_all();
}

void FilmRecorder::stop()
{
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    wakes_.notify_all();
}

bool FilmRecorder::is_done() const
{
    const std::lock_guard lock(mutex_);
    return done_;
}

std::string FilmRecorder::error() const
{
    const std::lock_guard lock(mutex_);
    return error_;
}

void FilmRecorder::run()
{
    std::string error;
    try {
        std::vector<std::uint8_t> rgb;
        for (;;) {
            std::unique_lock lock(mutex_);
            wakes_.wait(lock, [this] { return ends_ || !pieces_.empty(); });
            if (pieces_.empty()) break;
            const Piece piece = std::move(pieces_.front());
            pieces_.pop_front();
            lock.unlock();
            scale(*piece.frame, width_, height_, rgb);
            for (std::size_t k = 0; k < piece.repeats; ++k) writer_.add(rgb);
        }
        writer_.finish();
    } catch (const std::exception& failed) {
        error = failed.what();
    }
    const std::lock_guard lock(mutex_);
    error_ = error;
    done_ = ends_ = true;
}

} // namespace firsthit::cli::view
