// context_test.cpp - OpenGL contexts without a window.
#include "gl_context.h"
#include "message_of.h"

#include <epoxy/egl.h>

#include <cstdio>
#include <cstdlib>
#include <thread>

namespace firsthit {
namespace {

using Context = test::OnContext;

TEST_F(Context, HasOpenGl45AndNamesTheDriver)
{
    GLint major = 0, minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    EXPECT_GE(10 * major + minor, 45);
    EXPECT_FALSE(context->info().renderer.empty());
    EXPECT_NE(gl::driver_name().find(context->info().version), std::string::npos);
    EXPECT_GE(context->info().max_texture_size, 16384);
    EXPECT_GE(context->info().max_storage_bytes, 1 << 24);
    EXPECT_EQ(context->is_hardware(), gl::is_hardware_renderer(context->info().renderer));
}

TEST(HardwareRenderer, IsNoneOfTheSoftwareDrivers)
{
    EXPECT_FALSE(gl::is_hardware_renderer("llvmpipe (LLVM 15.0.6, 256 bits)"));
    EXPECT_FALSE(gl::is_hardware_renderer("softpipe"));
    EXPECT_FALSE(gl::is_hardware_renderer("Software Rasterizer"));
    EXPECT_TRUE(gl::is_hardware_renderer("AMD Radeon RX 6800 (radeonsi)"));
}

TEST_F(Context, IsCurrentOnlyInItsScope)
{
    const EGLContext mine = eglGetCurrentContext();
    {
        const gl::Context other;
        const gl::Current scope(other);
        EXPECT_NE(eglGetCurrentContext(), mine);
        {
            const gl::Current again(*context);
            EXPECT_EQ(eglGetCurrentContext(), mine);
        }
        EXPECT_NE(eglGetCurrentContext(), mine);
    }
    EXPECT_EQ(eglGetCurrentContext(), mine);
    current.reset();
    EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
    current = std::make_unique<gl::Current>(*context);
}

TEST_F(Context, IsRefusedOnASecondThread)
{
    std::string message;
    std::thread([&] {
        message = message_of<DeviceError>([&] { const gl::Current scope(*context); });
    }).join();
    EXPECT_NE(message.find("another"), std::string::npos) << message;
    EXPECT_NE(message.find(context->info().version), std::string::npos) << message;
}

TEST_F(Context, CallsThatAreRefusedAreErrorsThatNameTheDriver)
{
    glBindFramebuffer(GL_FRAMEBUFFER, 12345);
    const std::string message = message_of<DeviceError>([] { gl::check("testing"); });
    EXPECT_NE(message.find("GL_INVALID_OPERATION while testing"), std::string::npos) << message;
    EXPECT_NE(message.find(context->info().renderer), std::string::npos) << message;
    EXPECT_NO_THROW(gl::check("testing again"));
}

TEST(OldOpenGl, IsAnErrorThatNamesItsVersion)
{
    // The driver reads the variable once in a process, so a death test runs this in a new process.
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    if (std::getenv("MESA_GL_VERSION_OVERRIDE") == nullptr) {
        try {
            const gl::Context present;
            if (present.is_hardware()) GTEST_SKIP() << "hardware cannot pretend to be old";
        } catch (const DeviceError& error) {
            GTEST_SKIP() << error.what();
        }
    }
    setenv("MESA_GL_VERSION_OVERRIDE", "3.3", 1);
    const auto open_old = [] {
        const std::string message = message_of<DeviceError>([] { const gl::Context old; });
        std::fputs(message.c_str(), stderr);
        std::_Exit(0);
    };
    EXPECT_EXIT(
        open_old(), testing::ExitedWithCode(0), "version 4.5 core is needed, there is .*3.3");
    unsetenv("MESA_GL_VERSION_OVERRIDE");
}

} // namespace
} // namespace firsthit
