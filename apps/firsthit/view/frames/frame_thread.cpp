// frame_thread.cpp - the thread that makes the pictures of a session.
#include "view/frames/frame_thread.h"

#include "view/frames/frame_maker.h"

#include <firsthit/error.h>

#include <algorithm>
#include <exception>
#include <utility>

namespace firsthit::cli::view {
namespace {

bool same_request(const FrameRequest& a, const FrameRequest& b)
{
    return a.number == b.number && a.moving == b.moving && a.repeat == b.repeat;
}

} // namespace

struct FrameThread::Maker : FrameMaker {
    using FrameMaker::FrameMaker;
};

FrameThread::FrameThread(int threads, std::function<void()> has_news)
    : has_news_(std::move(has_news)),
      maker_(std::make_unique<Maker>(threads)),
      thread_([this](const std::stop_token& end) {
          run(end);
          maker_.reset(); // here: the caller's thread may have an OpenGL context of its own
      })
{
}

FrameThread::~FrameThread()
{
    thread_.request_stop(); // first, so that no other frame is begun
    {
        const std::lock_guard lock(mutex_);
        stop_.request_stop();
    }
    thread_.join();
}

void FrameThread::want(const FrameRequest& request)
{
    {
        const std::lock_guard lock(mutex_);
        wanted_ = request;
        if (in_work_) {
            const FrameRequest& now = *in_work_;
            const bool other = now.scene != request.scene || now.width != request.width ||
                               now.height != request.height;
            if (other || (!now.moving && !same_request(now, request))) stop_.request_stop();
        }
    }
    wakes_.notify_all();
}

void FrameThread::want_pick(int x, int y)
{
    {
        const std::lock_guard lock(mutex_);
        wanted_pick_ = glm::ivec2(x, y);
    }
    wakes_.notify_all();
}

std::shared_ptr<const ShownFrame> FrameThread::latest() const
{
    const std::lock_guard lock(mutex_);
    return latest_;
}

std::string FrameThread::error() const
{
    const std::lock_guard lock(mutex_);
    return error_;
}

std::uint64_t FrameThread::error_number() const
{
    const std::lock_guard lock(mutex_);
    return error_number_;
}

std::optional<Pick> FrameThread::latest_pick() const
{
    const std::lock_guard lock(mutex_);
    return pick_;
}

std::uint64_t FrameThread::cancelled() const
{
    const std::lock_guard lock(mutex_);
    return cancelled_;
}

/// A frame that nobody holds any more. With the lock.
std::shared_ptr<ShownFrame> FrameThread::unused_frame()
{
    std::shared_ptr<ShownFrame> unused;
    for (const std::shared_ptr<ShownFrame>& frame : frames_) {
        if (frame.use_count() > 1) continue;
        frame->request = {}; // so that it does not keep a scene
        unused = frame;
    }
    if (!unused) unused = frames_.emplace_back(std::make_shared<ShownFrame>());
    return unused;
}

void FrameThread::run(const std::stop_token& end)
{
    std::optional<FrameRequest> done;
    for (;;) {
        std::unique_lock lock(mutex_);
        const auto has_frame = [&] { return wanted_ && !(done && same_request(*done, *wanted_)); };
        const auto has_pick = [&] {
            return wanted_pick_ && done && !done->moving && latest_ && error_.empty();
        };
        wakes_.wait(lock, end, [&] { return has_frame() || has_pick(); });
        if (end.stop_requested()) return;
        if (!has_frame()) {
            const glm::ivec2 pixel = *std::exchange(wanted_pick_, {});
            lock.unlock();
            std::optional<Pick> found;
            try {
                found = maker_->pick(pixel.x, pixel.y);
            } catch (const std::exception&) {
                // A pixel outside of a picture that was made smaller, or a scene that cannot be shown.
            }
            lock.lock();
            pick_ = found;
            lock.unlock();
            has_news_();
            continue;
        }
        in_work_ = wanted_;
        stop_ = {};
        const FrameRequest request = *wanted_;
        const std::stop_token stop = stop_.get_token();
        const std::shared_ptr<ShownFrame> frame = unused_frame();
        lock.unlock();

        std::string error;
        bool cancelled = false;
        try {
            maker_->make(request, stop, *frame);
        } catch (const Cancelled&) {
            cancelled = true;
        } catch (const std::bad_alloc&) {
            error = "out of memory";
        } catch (const std::exception& failed) {
            error = failed.what();
        }
        lock.lock();
        in_work_.reset();
        if (cancelled) {
            ++cancelled_;
            continue;
        }
        done = request;
        error_ = error;
        error_number_ = error.empty() ? 0 : request.number;
        if (error.empty()) {
            latest_ = frame;
            pick_.reset(); // of another picture
        }
        lock.unlock();
        has_news_();
    }
}

} // namespace firsthit::cli::view
