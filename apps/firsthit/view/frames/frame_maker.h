// frame_maker.h - makes one picture of a session after the other.
#pragma once

#include "view/frames/frame_request.h"

#include <stop_token>

namespace firsthit::cli::view {

/// Keeps renderers, worlds and what is known of how long frames take.
class FrameMaker {
  public:
    /// threads  of the renderer; 0: one for each core
    explicit FrameMaker(int threads) : renderer_(threads), threads_(threads) {}

    /// Makes a picture into a frame whose memory is used again.
    /// throws  Cancelled; and as Renderer
    void make(const FrameRequest& request, const std::stop_token& stop, ShownFrame& shown);

    /// What is under a pixel of the last picture at rest.
    Pick pick(int x, int y);

  private:
    /// Poses the scene where that is not the pose already.
    void take_pose(const FrameRequest& request);
    Rung rung_of(const FrameRequest& request, int& number, int& count);
    void render_reference(
        const FrameRequest& request, const Settings& whole, const FrameControl& control);

    Renderer renderer_;
    std::unique_ptr<Renderer> exact_; // of Look::difference and wrong
    Renderer picks_{1};               // of single pixels
    int threads_;
    World world_;
    PoseSettings pose_; // of world_
    View view_;         // of the last picture, whole
    Film moving_, reference_;
    QualityLadder ladder_;
    FrameRequest last_;
};

} // namespace firsthit::cli::view
