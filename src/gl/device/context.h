// context.h - OpenGL 4.5 core without a display.
#pragma once

#include <cstdint>
#include <string>

namespace firsthit::gl {

/// Who draws, and how much it takes.
struct ContextInfo {
    std::string vendor;
    std::string renderer;
    std::string version;
    std::string platform; // "device" or "surfaceless"
    bool hardware = false;
    bool reports_resets = false;
    int max_texture_size = 0;           // texels on a side
    std::int64_t max_storage_bytes = 0; // of one shader storage block
};

/// Whether a renderer's name is not one of the known software drivers'.
bool is_hardware_renderer(const std::string& renderer);

/// A context through EGL, core profile, with notification of resets where there is any. No window,
/// no surface: who draws has framebuffer objects. Current on one thread at a time, see Current.
///
/// Takes the first device that has a hardware renderer; else Mesa's surfaceless platform.
class Context {
  public:
    /// throws  DeviceError: no EGL, no platform, no OpenGL 4.5; names driver and version. Also in a
    ///         child after fork() whose parent had a context
    Context();
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    const ContextInfo& info() const { return info_; }
    bool is_hardware() const { return info_.hardware; }

  private:
    friend class Current;
    bool open(void* display, const char* platform);

    void* display_ = nullptr; // EGLDisplay; never terminated: the process has one for all contexts
    void* context_ = nullptr; // EGLContext
    ContextInfo info_;
    std::string refusal_; // why the last display was not taken
};

/// Drivers keep threads and locks that a child after fork() lacks.
/// throws  DeviceError, always
[[noreturn]] void refuse_after_fork();

/// While it lives, the context is current on this thread; then what was current before is again.
class Current {
  public:
    /// throws  DeviceError: the context is current on another thread
    explicit Current(const Context& context);
    ~Current();
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;

  private:
    bool changed_ = false;
    void* display_ = nullptr; // ours, to let go
    void* old_display_ = nullptr;
    void* old_context_ = nullptr;
    void* old_draw_ = nullptr;
    void* old_read_ = nullptr;
    unsigned old_api_ = 0;
};

/// "llvmpipe (...), OpenGL 4.5 (Core Profile) Mesa ...": of the current context, for messages.
std::string driver_name();

/// Looks whether the current context is well; call it after allocating, and once a frame.
/// what    is being done, for the message: "drawing items"
/// throws  DeviceError: the context is lost, no memory is left, or a call was refused
void check(const char* what);

} // namespace firsthit::gl
