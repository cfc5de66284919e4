// context.cpp - OpenGL 4.5 core without a display.
#include "gl/device/context.h"

#include "base/process_owned.h"

#include <firsthit/error.h>

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <dlfcn.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace firsthit::gl {
namespace {

constexpr int kMajor = 4, kMinor = 5;

/// Checks that the libraries exist. libepoxy would end the process if one is missing.
void find_libraries()
{
    const auto is_there = [](const char* name) { return dlopen(name, RTLD_LAZY) != nullptr; };
    if (!is_there("libEGL.so.1"))
        throw DeviceError("OpenGL: there is no libEGL.so.1 (Debian packages libegl1 "
                          "libgl1-mesa-dri)");
    if (!is_there("libOpenGL.so.0") && !is_there("libGL.so.1"))
        throw DeviceError("OpenGL: there is neither libOpenGL.so.0 nor libGL.so.1 (Debian package "
                          "libgl1)");
}

/// Whether a list of names, separated by spaces, contains a name.
bool has_word(const char* words, std::string_view word)
{
    std::string_view rest = words ? words : "";
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        if (rest.substr(0, end) == word) return true;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return false;
}

/// The displays of all devices that are not software renderers.
std::vector<EGLDisplay> device_displays(const char* client)
{
    std::vector<EGLDisplay> displays;
    const bool base = has_word(client, "EGL_EXT_device_base");
    if (!base && !has_word(client, "EGL_EXT_device_enumeration")) return displays;
    if (!has_word(client, "EGL_EXT_platform_device")) return displays;
    EGLint count = 0;
    if (!eglQueryDevicesEXT(0, nullptr, &count) || count <= 0) return displays;
    std::vector<EGLDeviceEXT> devices{std::size_t(count)};
    if (!eglQueryDevicesEXT(count, devices.data(), &count)) return displays;
    devices.resize(std::size_t(std::max(count, 0)));
    const bool can_ask = base || has_word(client, "EGL_EXT_device_query");
    for (const EGLDeviceEXT device : devices) {
        const char* const extensions =
            can_ask ? eglQueryDeviceStringEXT(device, EGL_EXTENSIONS) : "";
        if (has_word(extensions, "EGL_MESA_device_software")) continue;
        const EGLDisplay display =
            eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
        if (display != EGL_NO_DISPLAY) displays.push_back(display);
    }
    return displays;
}

std::string text_of(GLenum name)
{
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text ? text : "?";
}

/// Creates a context; returns EGL_NO_CONTEXT on failure.
/// version  true: OpenGL 4.5 core; false: any version that the driver offers
/// resets   request notification of resets
EGLContext create(EGLDisplay display, EGLConfig config, bool version, bool resets)
{
    std::vector<EGLint> attributes;
    if (version)
        attributes = {EGL_CONTEXT_MAJOR_VERSION_KHR, kMajor, EGL_CONTEXT_MINOR_VERSION_KHR, kMinor,
            EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR};
    if (resets)
        attributes.insert(attributes.end(),
            {EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_KHR, EGL_LOSE_CONTEXT_ON_RESET_KHR});
    attributes.push_back(EGL_NONE);
    return eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
}

/// For the error message: the version of OpenGL on a display that does not support 4.5.
std::string found_instead(EGLDisplay display, EGLConfig config)
{
    std::string found;
    const EGLContext context = create(display, config, false, false);
    if (context == EGL_NO_CONTEXT) return "no OpenGL";
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
        found = driver_name();
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglDestroyContext(display, context);
    return found;
}

ContextInfo read_info(const char* platform, bool resets)
{
    ContextInfo info;
    info.vendor = text_of(GL_VENDOR);
    info.renderer = text_of(GL_RENDERER);
    info.version = text_of(GL_VERSION);
    info.platform = platform;
    info.hardware = is_hardware_renderer(info.renderer);
    info.reports_resets = resets;
    GLint size = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &size);
    info.max_texture_size = size;
    GLint64 bytes = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    info.max_storage_bytes = bytes;
    return info;
}

/// Makes glibc keep large blocks that are freed. Software drivers allocate and free tens of
/// megabytes in each frame. By default glibc returns such blocks to the system, which then has to
/// make their pages again (4.5 of 15 ms for 73,292 triangles at 1024x1024). Once a block of that
/// size was allocated and freed, glibc keeps blocks of up to its size.
void keep_freed_memory()
{
    // glibc raises its threshold to at most 32 MiB.
    void* volatile block = std::malloc(std::size_t(30) << 20);
    std::free(block);
}

const char* error_name(GLenum error)
{
    switch (error) {
    case GL_INVALID_ENUM:
        return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
        return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
        return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
        return "GL_INVALID_FRAMEBUFFER_OPERATION";
    default:
        return "an unknown error";
    }
}

} // namespace

bool is_hardware_renderer(const std::string& renderer)
{
    std::string name = renderer;
    std::transform(name.begin(), name.end(), name.begin(),
        [](unsigned char letter) { return char(std::tolower(letter)); });
    for (const char* software : {"llvmpipe", "softpipe", "swrast", "swiftshader", "software"})
        if (name.find(software) != std::string::npos) return false;
    return true;
}

void refuse_after_fork()
{
    throw DeviceError("OpenGL: it was used before fork(), so the child process cannot use it");
}

Context::Context()
{
    find_libraries();
    static const HomeProcess first; // EGL's displays belong to the process that first used them
    if (!first.is_this()) refuse_after_fork();
    const char* const client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!has_word(client, "EGL_EXT_platform_base"))
        throw DeviceError("OpenGL: EGL has no driver, or none that can do without a display "
                          "(EGL_EXT_platform_base; Debian packages libegl1 libgl1-mesa-dri)");
    for (const EGLDisplay display : device_displays(client)) {
        if (open(display, "device") && info_.hardware) return;
        if (context_) eglDestroyContext(display_, context_);
        context_ = nullptr;
    }
    if (!has_word(client, "EGL_MESA_platform_surfaceless"))
        throw DeviceError("OpenGL: EGL has neither a hardware device nor Mesa's surfaceless "
                          "platform (Debian packages libegl1 libgl1-mesa-dri)" +
                          (refusal_.empty() ? "" : "; " + refusal_));
    const EGLDisplay display =
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || !open(display, "surfaceless"))
        throw DeviceError(refusal_.empty() ? "OpenGL: no surfaceless EGL display" : refusal_);
}

bool Context::open(void* display, const char* platform)
{
    display_ = display;
    const auto refuse = [&](const std::string& why) {
        const char* const vendor = eglQueryString(display, EGL_VENDOR);
        const char* const version = eglQueryString(display, EGL_VERSION);
        refusal_ = fmt::format("OpenGL: {} (platform {}, EGL {} {})", why, platform,
            vendor ? vendor : "?", version ? version : "?");
        return false;
    };
    if (!eglInitialize(display, nullptr, nullptr))
        return refuse(fmt::format("EGL does not start, error 0x{:04X}", eglGetError()));
    const char* const extensions = eglQueryString(display, EGL_EXTENSIONS);
    if (!has_word(extensions, "EGL_KHR_surfaceless_context"))
        return refuse("EGL_KHR_surfaceless_context is missing");
    EGLConfig config = EGL_NO_CONFIG_KHR;
    const EGLint any[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLint configs = 0;
    if (!has_word(extensions, "EGL_KHR_no_config_context") &&
        (!eglChooseConfig(display, any, &config, 1, &configs) || configs == 0))
        return refuse("EGL has no configuration for OpenGL");

    const EGLenum old_api = eglQueryAPI();
    eglBindAPI(EGL_OPENGL_API);
    bool resets = has_word(extensions, "EGL_EXT_create_context_robustness");
    if (resets) context_ = create(display, config, true, true);
    if (!context_) {
        resets = false;
        context_ = create(display, config, true, false);
    }
    const EGLint error = eglGetError();
    const std::string instead = context_ ? "" : found_instead(display, config);
    eglBindAPI(old_api);
    if (!context_)
        return refuse(fmt::format("version {}.{} core is needed, there is {}; error 0x{:04X}",
            kMajor, kMinor, instead, error));
    const Current current(*this);
    info_ = read_info(platform, resets);
    if (!info_.hardware) keep_freed_memory();
    return true;
}

Context::~Context()
{
    if (context_) eglDestroyContext(display_, context_);
}

Current::Current(const Context& context) : display_(context.display_), old_api_(eglQueryAPI())
{
    eglBindAPI(EGL_OPENGL_API); // the API is a state of the thread
    old_context_ = eglGetCurrentContext();
    if (old_context_ != context.context_) {
        old_display_ = eglGetCurrentDisplay();
        old_draw_ = eglGetCurrentSurface(EGL_DRAW);
        old_read_ = eglGetCurrentSurface(EGL_READ);
        if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context.context_)) {
            const EGLint error = eglGetError();
            eglBindAPI(old_api_);
            throw DeviceError(
                fmt::format("OpenGL: the context cannot be used on this thread{}, EGL error "
                            "0x{:04X} ({}, {})",
                    error == EGL_BAD_ACCESS ? " while another one has it" : "", error,
                    context.info_.renderer, context.info_.version));
        }
        changed_ = true;
    }
}

Current::~Current()
{
    if (changed_) {
        if (old_context_)
            eglMakeCurrent(old_display_, old_draw_, old_read_, old_context_);
        else
            eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglBindAPI(old_api_);
}

std::string driver_name()
{
    return text_of(GL_RENDERER) + ", OpenGL " + text_of(GL_VERSION);
}

void check(const char* what)
{
    if (glGetGraphicsResetStatus() != GL_NO_ERROR)
        throw DeviceError(fmt::format("OpenGL: lost context while {} ({})", what, driver_name()));
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) return;
    for (int rest = 0; rest < 16 && glGetError() != GL_NO_ERROR; ++rest) {
    }
    if (error == GL_OUT_OF_MEMORY)
        throw DeviceError(fmt::format("OpenGL: no memory left for {} ({})", what, driver_name()));
    if (error == GL_CONTEXT_LOST)
        throw DeviceError(fmt::format("OpenGL: lost context while {} ({})", what, driver_name()));
    throw DeviceError(
        fmt::format("OpenGL: {} while {} ({})", error_name(error), what, driver_name()));
}

} // namespace firsthit::gl
