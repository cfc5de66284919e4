// context.h - an OpenGL 4.5 core context without a window.
#pragma once

#include <cstdint>
#include <string>

namespace firsthit::gl {

/// The driver of a context, and its limits.
struct ContextInfo {
    std::string vendor;
    std::string renderer;
    std::string version;
    std::string platform;               // "device" or "surfaceless"
    bool hardware = false;              // not a known software renderer
    bool reports_resets = false;        // check() notices a reset of the GPU
    int max_texture_size = 0;           // texels on a side
    std::int64_t max_storage_bytes = 0; // largest shader storage block
};

/// Whether a renderer is hardware: its name is not that of a known software driver.
bool is_hardware_renderer(const std::string& renderer);

/// A core profile context, made through EGL, with notification of resets if the driver supports it.
/// It has no window and no surface: drawing needs framebuffer objects. It can be current on one
/// thread at a time, see Current.
///
/// Uses the first device with a hardware renderer. If there is none, uses Mesa's surfaceless
/// platform.
class Context {
  public:
    /// throws  DeviceError: no EGL, no platform, no OpenGL 4.5 (the message names driver and
    ///         version); or this is a child process after fork(), and its parent had a context
    Context();
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    const ContextInfo& info() const { return info_; }
    bool is_hardware() const { return info_.hardware; }

  private:
    friend class Current;
    bool open(void* display, const char* platform);

    // EGLDisplay; never terminated, because all contexts of the process share it.
    void* display_ = nullptr;
    void* context_ = nullptr; // EGLContext
    ContextInfo info_;
    std::string refusal_; // why the last display could not be used
};

/// Reports the use of OpenGL in a child process. Drivers have threads, which do not exist after
/// fork().
/// throws  DeviceError, always
[[noreturn]] void refuse_after_fork();

/// While it exists, the context is current on this thread. Its destructor makes current what was
/// before.
class Current {
  public:
    /// throws  DeviceError: the context is current on another thread
    explicit Current(const Context& context);
    ~Current();
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;

  private:
    bool changed_ = false;
    void* display_ = nullptr; // of our context, to release it
    void* old_display_ = nullptr;
    void* old_context_ = nullptr;
    void* old_draw_ = nullptr;
    void* old_read_ = nullptr;
    unsigned old_api_ = 0;
};

/// Renderer and version of the current context, for messages: "llvmpipe (...), OpenGL 4.5 (Core
/// Profile) Mesa ...".
std::string driver_name();

/// Checks the current context for errors. To be called after allocations, and once in each frame.
/// what    what was being done, for the message: "drawing items"
/// throws  DeviceError: the context is lost, no memory is left, or a call was refused
void check(const char* what);

} // namespace firsthit::gl
