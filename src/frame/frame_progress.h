// frame_progress.h - how far a frame is, and whether it is still wanted.
#pragma once

#include <firsthit/frame_control.h>

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace firsthit {

/// Counts the work that is done of a frame, tells the caller on the caller's own thread, and gives
/// the frame up when it is asked to. Work is in whatever unit the engine likes.
class FrameProgress {
  public:
    explicit FrameProgress(const FrameControl& control) : control_(control) {}

    /// Begins a frame of so much work. An engine that begins after another one failed goes on where
    /// the share was.
    void begin(std::uint64_t work);

    /// throws  Cancelled: a stop was requested
    void check() const
    {
        if (control_.stop.stop_requested()) [[unlikely]]
            give_up();
    }

    /// So much more work is done. Calls of different workers may overlap; worker 0 is the thread of
    /// the caller.
    /// throws  as check, and what the caller's function throws
    void add(std::uint64_t work, std::size_t worker)
    {
        check();
        if (control_.progress) count(work, worker);
    }

    /// All is done.
    void finish();

  private:
    [[noreturn]] static void give_up();
    void count(std::uint64_t work, std::size_t worker);
    void report(double share);

    const FrameControl& control_;
    std::uint64_t work_ = 0;
    std::atomic<std::uint64_t> done_{0};
    double reported_ = -1; // of the caller's thread
};

/// A stage's part of the work, done in equal steps on the caller's thread.
struct StageProgress {
    FrameProgress* progress = nullptr; // null: nobody looks
    std::uint64_t work = 0;

    /// Step k of that many is done.
    void step(std::size_t k, std::size_t steps) const
    {
        if (progress) progress->add(work * (k + 1) / steps - work * k / steps, 0);
    }
};

} // namespace firsthit
