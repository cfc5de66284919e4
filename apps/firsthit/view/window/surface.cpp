// surface.cpp - the window on the screen with all that lives in its OpenGL context.
#include "view/window/surface.h"

#include "view/window/panels.h"
#include "view/window/window_input.h"

#include <firsthit/error.h>

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string_view>

namespace firsthit::cli::view {
namespace {

std::string glfw_error()
{
    const char* why = nullptr;
    glfwGetError(&why);
    return why ? why : "unknown";
}

GLFWwindow* make_window(const SurfaceOptions& options)
{
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    GLFWwindow* window =
        glfwCreateWindow(options.width, options.height, options.title.c_str(), nullptr, nullptr);
    if (window) return window;
    throw DeviceError(fmt::format("no window with OpenGL 3.3 can be made: {}", glfw_error()));
}

} // namespace

Glfw::Glfw()
{
    glfwSetErrorCallback(nullptr);
    if (glfwInit()) return;
    throw DeviceError(fmt::format(
        "no window can be shown ({}): there is no display; firsthit render makes pictures without "
        "one, and firsthit view --serve shows the scene in a page for a browser",
        glfw_error()));
}

Glfw::~Glfw()
{
    glfwTerminate();
}

void Surface::Destroy::operator()(GLFWwindow* window) const
{
    glfwDestroyWindow(window);
}

Surface::Panels::Panels(float text_scale)
{
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr; // nothing is written
    ImGui::StyleColorsDark();
    ImGui::GetStyle().WindowRounding = 4;
    ImGui::GetStyle().FrameRounding = 3;
    ImGui::GetIO().FontGlobalScale = text_scale;
    name_imgui_keys();
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

Surface::Panels::~Panels()
{
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
}

Surface::Surface(const SurfaceOptions& options) : window_(make_window(options))
{
    glfwMakeContextCurrent(handle());
    glfwSwapInterval(options.waits_for_screen ? 1 : 0);
    float scale = 1, unused = 1;
    glfwGetWindowContentScale(handle(), &scale, &unused);
    // Where a unit is a pixel though the screen is dense, text grows; else the system scales it.
    const Extent size = extent();
    panels_ =
        std::make_unique<Panels>(size.width_pixels == size.width ? std::max(1.0f, scale) : 1.0f);
    picture_ = std::make_unique<PictureQuad>();
    const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    const std::string_view name = renderer ? renderer : "";
    draws_on_cpu_ = name.find("llvmpipe") != name.npos || name.find("softpipe") != name.npos;
}

Surface::~Surface()
{
    picture_.reset();
    panels_.reset();
}

Surface::Extent Surface::extent() const
{
    Extent size;
    glfwGetWindowSize(handle(), &size.width, &size.height);
    glfwGetFramebufferSize(handle(), &size.width_pixels, &size.height_pixels);
    return size;
}

void Surface::upload(const ShownFrame& frame)
{
    picture_->upload(frame.rgba, frame.width, frame.height);
}

void Surface::draw(ViewSession& session, Clock::time_point now)
{
    const Extent size = extent();
    if (size.is_empty()) return;
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {float(size.width), float(size.height)};
    io.DisplayFramebufferScale = {float(size.width_pixels) / float(size.width),
        float(size.height_pixels) / float(size.height)};
    const double passed_s = std::chrono::duration<double>(now - drawn_).count();
    io.DeltaTime = float(std::clamp(passed_s, 1e-4, 0.25));
    drawn_ = now;
    picture_->draw(size.width_pixels, size.height_pixels);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    draw_panels(session, now);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Surface::swap()
{
    glfwSwapBuffers(handle());
}

bool Surface::is_lost() const
{
    if (epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_KHR_robustness"))
        return glGetGraphicsResetStatus() != GL_NO_ERROR;
    if (epoxy_has_gl_extension("GL_ARB_robustness"))
        return glGetGraphicsResetStatusARB() != GL_NO_ERROR;
    return false;
}

Surface::Pixels Surface::drawn() const
{
    const Extent size = extent();
    Pixels pixels{.width = size.width_pixels, .height = size.height_pixels};
    const auto rows = std::size_t(pixels.height), row = std::size_t(pixels.width) * 4;
    std::vector<std::uint8_t> lowest_first(row * rows);
    pixels.rgba.resize(row * rows);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, pixels.width, pixels.height, GL_RGBA, GL_UNSIGNED_BYTE, lowest_first.data());
    for (std::size_t y = 0; y < rows; ++y)
        std::copy_n(&lowest_first[(rows - 1 - y) * row], row, &pixels.rgba[y * row]);
    return pixels;
}

} // namespace firsthit::cli::view
