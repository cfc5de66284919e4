// frame_thread.h - the thread that makes the pictures of a session, and drops those that are not wanted any more.
#pragma once

#include "view/frames/frame_request.h"

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

namespace firsthit::cli::view {

/// Shares its latest picture with any thread. Asking never waits for a frame.
class FrameThread {
  public:
    /// threads   of the renderer; 0: one for each core
    /// has_news  called on the frames' thread when there is a picture, an error or a pick to fetch
    FrameThread(int threads, std::function<void()> has_news);
    ~FrameThread();
    FrameThread(const FrameThread&) = delete;
    FrameThread& operator=(const FrameThread&) = delete;

    /// Asks for a picture in the place of the one asked for before. A frame at rest that is in work is
    /// cancelled between tiles; one of something that moves is finished, because it is nearly done, unless
    /// another scene or size is wanted.
    void want(const FrameRequest& request);

    /// Asks what is under a pixel of the next picture at rest, in the place of what was asked before.
    void want_pick(int x, int y);

    /// The latest picture; null: none yet.
    std::shared_ptr<const ShownFrame> latest() const;
    /// What went wrong in the latest request; empty: nothing.
    std::string error() const;
    /// Of which state the error is; 0: there is none.
    std::uint64_t error_number() const;
    /// The latest answer, of the picture of that number.
    std::optional<Pick> latest_pick() const;
    /// How many frames were given up.
    std::uint64_t cancelled() const;

  private:
    struct Maker;
    void run(const std::stop_token& end);
    std::shared_ptr<ShownFrame> unused_frame();

    mutable std::mutex mutex_;
    std::condition_variable_any wakes_;
    std::optional<FrameRequest> wanted_;
    std::optional<FrameRequest> in_work_;
    std::stop_source stop_;
    std::optional<glm::ivec2> wanted_pick_;
    std::optional<Pick> pick_;
    std::string error_;
    std::uint64_t error_number_ = 0;
    std::uint64_t cancelled_ = 0;
    std::vector<std::shared_ptr<ShownFrame>> frames_; // whose memory is used again
    std::shared_ptr<const ShownFrame> latest_;
    std::function<void()> has_news_;
    std::unique_ptr<Maker> maker_; // of the thread
    std::jthread thread_;          // last: it uses all others
};

} // namespace firsthit::cli::view
