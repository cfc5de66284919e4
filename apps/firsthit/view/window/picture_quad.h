// picture_quad.h - shows pixels on all of the window, by OpenGL 3.3.
#pragma once

#include <cstdint>
#include <vector>

namespace firsthit::cli::view {

/// A texture and a triangle that covers the window. Lives and dies with a current context.
class PictureQuad {
  public:
    /// throws  DeviceError: a shader that the driver does not take
    PictureQuad();
    ~PictureQuad();
    PictureQuad(const PictureQuad&) = delete;
    PictureQuad& operator=(const PictureQuad&) = delete;

    /// Takes pixels (height, width, 4), top row first.
    void upload(const std::vector<std::uint8_t>& rgba, int width, int height);
    /// Draws them over a framebuffer, each to its own pixel where sizes are equal, else smoothly.
    void draw(int framebuffer_width, int framebuffer_height);

  private:
    unsigned texture_ = 0, program_ = 0, vertices_ = 0;
    int width_ = 0, height_ = 0;
};

} // namespace firsthit::cli::view
