// frame_progress.cpp - reports the progress of a frame and stops it on request.
#include "frame/frame_progress.h"

#include <firsthit/error.h>

namespace firsthit {
namespace {

/// Progress is reported in steps of at least this share.
constexpr double kStep = 1.0 / 1024;

} // namespace

void FrameProgress::begin(std::uint64_t work)
{
    check();
    work_ = work;
    done_ = 0;
    if (control_.progress && reported_ < 0) report(0);
    check();
}

void FrameProgress::count(std::uint64_t work, std::size_t worker)
{
    const std::uint64_t done = done_.fetch_add(work, std::memory_order_relaxed) + work;
    if (worker != 0 || done >= work_) return; // finish() reports 1
    const double share = double(done) / double(work_);
    if (share < reported_ + kStep) return;
    report(share);
    check();
}

void FrameProgress::finish()
{
    if (control_.progress) report(1);
}

void FrameProgress::report(double share)
{
    reported_ = share;
    control_.progress(share);
}

void FrameProgress::give_up()
{
    throw Cancelled("the frame was cancelled");
}

} // namespace firsthit
