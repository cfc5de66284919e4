// surface.h - the window on the screen with all that lives in its OpenGL context: the picture and the panels.
#pragma once

#include "view/session/view_session.h"
#include "view/window/picture_quad.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace firsthit::cli::view {

/// GLFW from its start to its end. Outlives all surfaces.
class Glfw {
  public:
    /// throws  DeviceError: there is no display
    Glfw();
    ~Glfw();
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;
};

/// What a surface is made with.
struct SurfaceOptions {
    int width = 1280, height = 720; // units of the screen
    std::string title{};
    bool waits_for_screen = true; // swap() waits until the screen takes the next picture
};

/// One at a time. After a lost context another one takes its place.
class Surface {
  public:
    /// throws  DeviceError: no window, no OpenGL 3.3
    explicit Surface(const SurfaceOptions& options);
    ~Surface();
    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;

    GLFWwindow* handle() const { return window_.get(); }

    struct Extent {
        int width = 0, height = 0;               // units of the screen, in which pointers move
        int width_pixels = 0, height_pixels = 0; // more of them on a dense screen
        bool is_empty() const
        {
            return width < 1 || height < 1 || width_pixels < 1 || height_pixels < 1;
        }
    };
    /// Empty where the window is minimised.
    Extent extent() const;

    void upload(const ShownFrame& frame);
    /// Draws picture and panels into the back buffer.
    void draw(ViewSession& session, Clock::time_point now);
    void swap();
    /// Whether OpenGL is Mesa's software driver, which draws on the cores that make pictures.
    bool draws_on_cpu() const { return draws_on_cpu_; }
    /// Whether the driver has lost the context, as after a crash of its own.
    bool is_lost() const;

    /// A picture of pixels (height, width, 4), top row first.
    struct Pixels {
        int width = 0, height = 0;
        std::vector<std::uint8_t> rgba{};
    };
    /// What was drawn last.
    Pixels drawn() const;

  private:
    struct Destroy {
        void operator()(GLFWwindow* window) const;
    };
    /// ImGui with a current context.
    struct Panels {
        explicit Panels(float text_scale);
        ~Panels();
        Panels(const Panels&) = delete;
        Panels& operator=(const Panels&) = delete;
    };

    std::unique_ptr<GLFWwindow, Destroy> window_;
    std::unique_ptr<Panels> panels_;
    std::unique_ptr<PictureQuad> picture_;
    Clock::time_point drawn_{};
    bool draws_on_cpu_ = false;
};

} // namespace firsthit::cli::view
