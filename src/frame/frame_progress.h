// frame_progress.h - reports the progress of a frame and stops it on request.
#pragma once

#include <firsthit/frame_control.h>

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace firsthit {

/// Counts the work of a frame, reports progress to the caller on the caller's own thread, and stops
/// the frame if the caller requests it. Each engine chooses its own unit of work.
class FrameProgress {
  public:
    explicit FrameProgress(const FrameControl& control) : control_(control) {}

    /// Begins a frame with the given total amount of work. If another engine failed before, the
    /// reported progress does not go back.
    /// throws  as check, and what the caller's function throws
    void begin(std::uint64_t work);

    /// throws  Cancelled: a stop was requested
    void check() const
    {
        if (control_.stop.stop_requested()) [[unlikely]]
            give_up();
    }

    /// Adds work that is done. Calls of different workers may overlap; worker 0 is the caller's
    /// thread.
    /// throws  as check, and what the caller's function throws
    void add(std::uint64_t work, std::size_t worker)
    {
        check();
        if (control_.progress) count(work, worker);
    }

    /// Reports that the frame is done.
    void finish();

  private:
    [[noreturn]] static void give_up();
    void count(std::uint64_t work, std::size_t worker);
    void report(double share);

    const FrameControl& control_;
    std::uint64_t work_ = 0;
    std::atomic<std::uint64_t> done_{0};
    double reported_ = -1; // last reported share; only the caller's thread uses it
};

/// The work of one stage, which is done in equal steps on the caller's thread.
struct StageProgress {
    FrameProgress* progress = nullptr; // null: progress is not reported
    std::uint64_t work = 0;

    /// Reports that step k, counted from 0, of `steps` steps is done.
    void step(std::size_t k, std::size_t steps) const
    {
        if (progress) progress->add(work * (k + 1) / steps - work * k / steps, 0);
    }
};

} // namespace firsthit
