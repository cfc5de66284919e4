// frame_control.h - progress and cancellation of a frame.
#pragma once

#include <functional>
#include <stop_token>

namespace firsthit {

/// How a caller follows a frame while it is made, and cancels it. By default it does neither.
struct FrameControl {
    /// Cancels the frame. After a request, which may come from any thread, the tiles in work (or,
    /// on the gpu engine, the current pass) are finished, and render() throws Cancelled (error.h).
    std::stop_token stop;

    /// Receives the share of the frame that is done: first 0, then increasing values, and finally 1
    /// unless the frame was cancelled. It is called on the thread that called render(), before
    /// render() returns. It may request a stop. It must not call the renderer, and must leave the
    /// thread's OpenGL context as it found it. If it throws, the frame is cancelled and render()
    /// throws the same exception.
    std::function<void(double)> progress;
};

} // namespace firsthit
