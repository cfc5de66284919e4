// window.cpp - the window of `firsthit view`: GLFW and ImGui in front of a session.
#include "view/window/window.h"

#include "common/interrupt.h"
#include "common/output.h"
#include "common/usage.h"
#include "view/window/panels.h"
#include "view/window/picture_quad.h"
#include "view/window/window_input.h"

#include <firsthit/error.h>

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <thread>

namespace firsthit::cli::view {
namespace {

/// How long the window sleeps without an event: while something moves, and at rest.
constexpr double kMovingWait_s = 0.002, kRestWait_s = 0.25;
/// Panels need some frames to settle after an event.
constexpr int kRedraws = 3;

/// GLFW from its start to its end.
class Glfw {
  public:
    Glfw()
    {
        glfwSetErrorCallback(nullptr);
        if (glfwInit()) return;
        const char* why = nullptr;
        glfwGetError(&why);
        throw DeviceError(
            fmt::format("no window can be shown ({}): there is no display; firsthit render "
                        "makes pictures without one",
                why ? why : "unknown"));
    }
    ~Glfw() { glfwTerminate(); }
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;
};

GLFWwindow* make_window(int width, int height, const std::string& title)
{
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    GLFWwindow* window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (window) return window;
    const char* why = nullptr;
    glfwGetError(&why);
    throw DeviceError(
        fmt::format("no window with OpenGL 3.3 can be made: {}", why ? why : "unknown"));
}

/// ImGui from its start to its end, with a current context.
class Panels {
  public:
    explicit Panels(float scale)
    {
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr; // nothing is written
        ImGui::StyleColorsDark();
        ImGui::GetStyle().WindowRounding = 4;
        ImGui::GetStyle().FrameRounding = 3;
        ImGui::GetIO().FontGlobalScale = scale;
        name_imgui_keys();
        ImGui_ImplOpenGL3_Init("#version 330 core");
    }
    ~Panels()
    {
        ImGui_ImplOpenGL3_Shutdown();
        ImGui::DestroyContext();
    }
    Panels(const Panels&) = delete;
    Panels& operator=(const Panels&) = delete;
};

class Window {
  public:
    Window(const ViewOptions& options, ScriptPlayer* script);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;
    void run();

  private:
    static Window& of(GLFWwindow* window)
    {
        return *static_cast<Window*>(glfwGetWindowUserPointer(window));
    }
    void listen();
    void fit();
    void draw(Clock::time_point now);
    void show(Clock::time_point now);
    void screenshot(const std::string& path);
    bool look_for_frame();

    const ViewOptions& options_;
    ScriptPlayer* script_;
    Glfw glfw_;
    GLFWwindow* window_ = nullptr;
    std::optional<Panels> panels_;
    std::optional<PictureQuad> quad_;
    std::optional<ViewSession> session_;
    std::optional<WindowInput> input_;
    std::shared_ptr<const ShownFrame> frame_; // in the texture
    bool frame_is_new_ = false;
    int redraws_ = kRedraws;
    Clock::time_point drawn_{}, swapped_{};
};

Window::Window(const ViewOptions& options, ScriptPlayer* script)
    : options_(options),
      script_(script)
{
    const Size size = options.picture.camera.pixels();
    window_ =
        make_window(size.width, size.height, "firsthit - " + options.picture.scene.shown_name());
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(options.fps_limit > 0 ? 0 : 1);
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    int units = 1, pixels = 1, unused = 0;
    glfwGetWindowSize(window_, &units, &unused);
    glfwGetFramebufferSize(window_, &pixels, &unused);
    // Where a unit is a pixel though the screen is dense, text grows; else the system scales it.
    panels_.emplace(pixels == units ? std::max(1.0f, x) : 1.0f);
    quad_.emplace();
    session_.emplace(options.picture, [] { glfwPostEmptyEvent(); });
    session_->choose_switch("rate", fmt::format("{}", options.rate));
    input_.emplace(*session_);
    input_->set_window([this](int w, int h) { glfwSetWindowSize(window_, w, h); },
        [this](const std::string& path) { screenshot(path); });
    listen();
    fit();
}

Window::~Window()
{
    input_.reset();
    session_.reset();
    quad_.reset();
    panels_.reset();
    glfwDestroyWindow(window_);
}

void Window::listen()
{
    glfwSetWindowUserPointer(window_, this);
    glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
        of(w).redraws_ = kRedraws;
        of(w).input_->pointer_moves(x, y);
    });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int modifiers) {
        of(w).redraws_ = kRedraws;
        if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
        const Button which = button == GLFW_MOUSE_BUTTON_LEFT    ? Button::left
                             : button == GLFW_MOUSE_BUTTON_RIGHT ? Button::right
                                                                 : Button::middle;
        of(w).input_->button(which, action == GLFW_PRESS, (modifiers & GLFW_MOD_SHIFT) != 0);
    });
    glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double steps) {
        of(w).redraws_ = kRedraws;
        of(w).input_->scroll(steps);
    });
    glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int modifiers) {
        of(w).redraws_ = kRedraws;
        const std::string name = key_name(key, modifiers);
        if (!name.empty()) of(w).input_->key(name, action != GLFW_RELEASE);
    });
    glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned code) { of(w).input_->letter(code); });
    glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
        of(w).redraws_ = kRedraws;
        if (count > 0) of(w).session_->open(paths[0]);
    });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { of(w).fit(); });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { of(w).redraws_ = kRedraws; });
}

/// Takes the size of the window over, in pixels. A minimised one has none.
void Window::fit()
{
    int width = 0, height = 0, units = 0, unused = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    glfwGetWindowSize(window_, &units, &unused);
    if (width < 1 || height < 1 || units < 1) return;
    input_->set_scale(double(width) / units);
    session_->resize(width, height);
    redraws_ = kRedraws;
}

bool Window::look_for_frame()
{
    const std::shared_ptr<const ShownFrame> frame = session_->latest();
    if (!frame || frame == frame_) return false;
    quad_->upload(frame->rgba, frame->width, frame->height);
    frame_ = frame;
    frame_is_new_ = true;
    return true;
}

void Window::draw(Clock::time_point now)
{
    ImGuiIO& io = ImGui::GetIO();
    int width = 0, height = 0, pixels_x = 0, pixels_y = 0;
    glfwGetWindowSize(window_, &width, &height);
    glfwGetFramebufferSize(window_, &pixels_x, &pixels_y);
    if (width < 1 || height < 1 || pixels_x < 1 || pixels_y < 1) return; // minimised
    io.DisplaySize = {float(width), float(height)};
    io.DisplayFramebufferScale = {float(pixels_x) / float(width), float(pixels_y) / float(height)};
    const double passed = std::chrono::duration<double>(now - drawn_).count();
    io.DeltaTime = float(std::clamp(passed, 1e-4, 0.25));
    drawn_ = now;
    quad_->draw(pixels_x, pixels_y);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    draw_panels(*session_, now);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Window::show(Clock::time_point now)
{
    if (options_.fps_limit > 0) {
        const auto least = std::chrono::duration<double>(1 / options_.fps_limit);
        std::this_thread::sleep_until(
            swapped_ + std::chrono::duration_cast<Clock::duration>(least));
    }
    draw(now);
    glfwSwapBuffers(window_);
    swapped_ = Clock::now();
    if (frame_is_new_) session_->shown(*frame_, swapped_);
    frame_is_new_ = false;
    if (redraws_ > 0) --redraws_;
}

void Window::screenshot(const std::string& path)
{
    look_for_frame();
    for (int k = 0; k < kRedraws; ++k) draw(Clock::now());
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    const std::size_t row = std::size_t(width) * 4;
    std::vector<std::uint8_t> below(row * std::size_t(height)), rgba(below.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, below.data());
    for (std::size_t y = 0; y < std::size_t(height); ++y) // OpenGL's first row is the lowest
        std::copy_n(&below[(std::size_t(height) - 1 - y) * row], row, &rgba[y * row]);
    write_pixels(rgba, width, height, path);
}

void Window::run()
{
    const bool measured_at_end = options_.measure;
    while (!glfwWindowShouldClose(window_) && !session_->wants_end()) {
        Clock::time_point now = Clock::now();
        const bool busy = script_ || session_->is_moving(now) || redraws_ > 0;
        glfwWaitEventsTimeout(busy ? kMovingWait_s : kRestWait_s);
        now = Clock::now();
        session_->update(now);
        if (const auto copied = session_->take_copied())
            glfwSetClipboardString(window_, copied->c_str());
        const bool iconified = glfwGetWindowAttrib(window_, GLFW_ICONIFIED) != 0;
        const bool fresh = look_for_frame();
        const bool old = now - swapped_ > std::chrono::milliseconds(200);
        if (!iconified && (fresh || redraws_ > 0 || old)) show(now);
        if (!script_) continue;
        redraws_ = std::max(redraws_, 1); // panels answer a script's hand
        if (!script_->step(*session_, *input_, Clock::now())) break;
    }
    if (!options_.screenshot.empty()) screenshot(options_.screenshot);
    if (measured_at_end) print(measured(*session_));
}

} // namespace

int show_window(const ViewOptions& options, ScriptPlayer* script)
{
    Window(options, script).run();
    return kExitDone;
}

} // namespace firsthit::cli::view
