// frame_request.h - what the thread that makes frames is asked for, and what it gives.
#pragma once

#include "view/frames/pick.h"
#include "view/frames/quality.h"
#include "view/frames/view_scene.h"
#include "view/frames/view_state.h"

#include <firsthit/render.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace firsthit::cli::view {

using Clock = std::chrono::steady_clock;

/// One picture.
struct FrameRequest {
    std::uint64_t number = 0; // of the state that it shows; grows
    std::shared_ptr<ViewScene> scene{};
    PoseSettings pose{};
    std::optional<Camera> camera{}; // none: the one that the scene starts with
    int width = 0;                  // pixels of the window
    int height = 0;
    ViewState state{};
    bool moving = false; // something moves: what is dear may be left out
    double most_ms = 16; // and the frame is to take no longer than this
    int repeat = 0; // a frame of one state that is to be made once more has another number here
};

/// A picture that was made.
struct ShownFrame {
    FrameRequest request;
    std::vector<std::uint8_t> rgba; // (height, width, 4) sRGB
    int width = 0;                  // pixels; smaller than the window's while something moves
    int height = 0;
    Film film;           // at rest, with colours: the picture of `render`
    std::string missing; // what was left out; empty: it is exact
    std::string note;    // why it is not what was asked for, or nothing
    Stats stats;
    EngineInfo engine;
    double made_ms = 0;          // from the request's begin to pixels
    Camera camera;               // that it was seen with
    Box box{};                   // of the posed scene; of frames at rest
    std::optional<Box> selected; // of the selected instance; of frames at rest
    double middle_t =
        0; // how far what is seen in the middle is along the axis; 0: nothing, or not known
    Clock::time_point state_time{}; // when its making began: its age counts from then
};

} // namespace firsthit::cli::view
