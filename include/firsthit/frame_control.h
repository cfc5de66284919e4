// frame_control.h - to follow a frame while it is made, and to give it up.
#pragma once

#include <functional>
#include <stop_token>

namespace firsthit {

/// What a caller has to say while a frame is made. Nothing by default.
struct FrameControl {
    /// Once a stop is requested, from whatever thread, the frame is given up as soon as the tiles in
    /// work are done, or on the gpu engine the pass: render() throws Cancelled (error.h).
    std::stop_token stop;

    /// Is told the share of the frame that is done: 0 first, then more and more, and 1 at last, where
    /// the frame was not given up. Called on the thread that called render(), before it returns. It
    /// may request a stop. It must not call the renderer, and leaves the thread's OpenGL context as
    /// it found it; what it throws comes out of render(), as if the frame had been cancelled.
    std::function<void(double)> progress;
};

} // namespace firsthit
