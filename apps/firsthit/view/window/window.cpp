// window.cpp - the loop of the window: events, frames, the screen.
#include "view/window/window.h"

#include "common/output.h"
#include "common/stopwatch.h"
#include "common/usage.h"
#include "view/frames/write_pixels.h"
#include "view/window/surface.h"
#include "view/window/window_input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>

namespace firsthit::cli::view {
namespace {

/// How long the window sleeps without an event: while something moves, and at rest.
constexpr double kMovingWait_s = 0.002, kRestWait_s = 0.25;
/// How long panels wait for a picture.
constexpr std::chrono::milliseconds kPanelsWait{30};
/// Panels need some frames to settle after an event.
constexpr int kRedraws = 3;

class Window {
  public:
    Window(const ViewOptions& options, ScriptPlayer* script);
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;
    void run();

  private:
    static Window& of(GLFWwindow* window)
    {
        return *static_cast<Window*>(glfwGetWindowUserPointer(window));
    }
    GLFWwindow* handle() const { return surface_->handle(); }
    void make_surface(int width, int height);
    void listen();
    void fit();
    void renew();
    void look_for_news();
    bool is_due(Clock::time_point now) const;
    void show(Clock::time_point now);
    void screenshot(const std::string& path);

    const ViewOptions& options_;
    ScriptPlayer* script_;
    std::atomic<bool> has_news_ = false; // set by other threads
    Glfw glfw_;
    std::unique_ptr<Surface> surface_;
    std::optional<ViewSession> session_;
    std::optional<WindowInput> input_;
    std::shared_ptr<const ShownFrame> frame_; // in the texture
    std::string message_;                     // that was drawn
    bool frame_is_new_ = false;
    int redraws_ = kRedraws;
    Clock::time_point swapped_{};
};

Window::Window(const ViewOptions& options, ScriptPlayer* script)
    : options_(options),
      script_(script)
{
    const Size size = options.picture.camera.pixels();
    make_surface(size.width, size.height);
    session_.emplace(
        options.picture,
        [this] {
            has_news_ = true;
            glfwPostEmptyEvent();
        },
        RecentFiles(script ? "" : RecentFiles::usual_path()));
    session_->choose_switch("rate", fmt::format("{}", options.rate));
    input_.emplace(*session_);
    input_->set_window({.resize = [this](int w, int h) { glfwSetWindowSize(handle(), w, h); },
        .screenshot = [this](const std::string& path) { screenshot(path); },
        .renew = [this] { renew(); }});
    listen();
    fit();
}

void Window::make_surface(int width, int height)
{
    surface_ = std::make_unique<Surface>(SurfaceOptions{.width = width,
        .height = height,
        .title = "firsthit - " + options_.picture.scene.shown_name(),
        .waits_for_screen = options_.fps_limit == 0});
}

void Window::listen()
{
    GLFWwindow* window = handle();
    glfwSetWindowUserPointer(window, this);
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
        of(w).redraws_ = kRedraws;
        of(w).input_->pointer_moves(x, y);
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int modifiers) {
        of(w).redraws_ = kRedraws;
        if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
        const Button which = button == GLFW_MOUSE_BUTTON_LEFT    ? Button::left
                             : button == GLFW_MOUSE_BUTTON_RIGHT ? Button::right
                                                                 : Button::middle;
        of(w).input_->button(which, action == GLFW_PRESS, (modifiers & GLFW_MOD_SHIFT) != 0);
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double, double steps) {
        of(w).redraws_ = kRedraws;
        of(w).input_->scroll(steps);
    });
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int modifiers) {
        of(w).redraws_ = kRedraws;
        const std::string name = key_name(key, modifiers);
        if (!name.empty()) of(w).input_->key(name, action != GLFW_RELEASE);
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned code) {
        of(w).redraws_ = kRedraws;
        of(w).input_->letter(code);
    });
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
        of(w).redraws_ = kRedraws;
        if (count > 0) of(w).session_->open(paths[0]);
    });
    // Keys that are held when the window loses the keyboard are never seen to be let go.
    glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
        if (!focused) of(w).session_->release_all();
    });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { of(w).fit(); });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { of(w).redraws_ = kRedraws; });
}

/// Takes the size of the window over, in pixels. A minimised one has none.
void Window::fit()
{
    const Surface::Extent size = surface_->extent();
    if (size.is_empty()) return;
    input_->set_scale(double(size.width_pixels) / size.width);
    session_->resize(size.width_pixels, size.height_pixels);
    redraws_ = kRedraws;
}

/// Another window in the place of this one, whose context was lost. The session goes on.
void Window::renew()
{
    const Surface::Extent size = surface_->extent();
    int x = 0, y = 0;
    glfwGetWindowPos(handle(), &x, &y);
    surface_.reset();
    make_surface(std::max(1, size.width), std::max(1, size.height));
    glfwSetWindowPos(handle(), x, y);
    listen();
    fit();
    frame_.reset(); // so that it is uploaded again
    session_->release_all();
}

void Window::look_for_news()
{
    if (has_news_.exchange(false) || input_->waits()) redraws_ = std::max(redraws_, 1);
    if (session_->message() != message_) redraws_ = std::max(redraws_, 1);
    const std::shared_ptr<const ShownFrame> frame = session_->latest();
    if (!frame || frame == frame_) return;
    surface_->upload(*frame);
    frame_ = frame;
    frame_is_new_ = true;
    redraws_ = std::max(redraws_, 1);
}

/// Whether the window is to be drawn. While something moves, panels wait for the picture that is in work: drawn at
/// once, they would hold it up.
bool Window::is_due(Clock::time_point now) const
{
    const auto since = now - swapped_;
    if (redraws_ == 0) return false;
    if (options_.fps_limit > 0 && since < std::chrono::duration<double>(1 / options_.fps_limit))
        return false;
    return frame_is_new_ || since >= kPanelsWait || !session_->is_moving(now);
}

void Window::show(Clock::time_point now)
{
    const Stopwatch watch;
    surface_->draw(*session_, now);
    surface_->swap();
    if (surface_->draws_on_cpu()) session_->note_showing(watch.ms());
    input_->panels_are_drawn();
    swapped_ = Clock::now();
    message_ = session_->message();
    if (frame_is_new_) session_->shown(*frame_, swapped_);
    frame_is_new_ = false;
    --redraws_;
}

void Window::screenshot(const std::string& path)
{
    look_for_news();
    for (int k = 0; k < kRedraws; ++k) surface_->draw(*session_, Clock::now());
    const Surface::Pixels pixels = surface_->drawn();
    write_pixels(pixels.rgba, pixels.width, pixels.height, path);
}

void Window::run()
{
    while (!glfwWindowShouldClose(handle()) && !session_->wants_end()) {
        const bool busy = script_ || session_->is_moving(Clock::now()) || redraws_ > 0;
        glfwWaitEventsTimeout(busy ? kMovingWait_s : kRestWait_s);
        const Clock::time_point now = Clock::now();
        session_->update(now);
        if (const auto copied = session_->take_copied())
            glfwSetClipboardString(handle(), copied->c_str());
        if (surface_->is_lost()) renew();
        look_for_news();
        const bool iconified = glfwGetWindowAttrib(handle(), GLFW_ICONIFIED) != 0;
        const bool shows = !iconified && is_due(now);
        if (shows) show(now);
        if (iconified) input_->panels_are_drawn(); // there are none to wait for
        if (!script_) continue;
        redraws_ = std::max(redraws_, 1); // panels answer a script's hand
        if (!shows && !iconified && now - swapped_ < kPanelsWait)
            continue; // once a picture, as a hand does
        if (!script_->step(*session_, *input_, Clock::now())) break;
    }
    if (!options_.screenshot.empty()) screenshot(options_.screenshot);
    if (options_.measure) print(measured(*session_));
}

} // namespace

int show_window(const ViewOptions& options, ScriptPlayer* script)
{
    Window(options, script).run();
    return kExitDone;
}

} // namespace firsthit::cli::view
