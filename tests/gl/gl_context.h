// gl_context.h - an OpenGL context for tests, or the reason why there is none.
#pragma once

#include "gl/device/context.h"
#include "gl/device/objects.h"

#include <firsthit/error.h>

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace firsthit::test {

/// A test that has its own current context. It is skipped if there is no OpenGL. It fails if it
/// leaves an OpenGL error or object behind.
class OnContext : public testing::Test {
  protected:
    void SetUp() override
    {
        try {
            context = std::make_unique<gl::Context>();
        } catch (const DeviceError& error) {
            GTEST_SKIP() << error.what();
        }
        current = std::make_unique<gl::Current>(*context);
        alive_before_ = gl::gl_objects_alive();
    }

    void TearDown() override
    {
        if (!context) return;
        EXPECT_NO_THROW(gl::check("ending a test"));
        EXPECT_EQ(gl::gl_objects_alive(), alive_before_) << "objects are left";
        current.reset();
        context.reset();
    }

    std::unique_ptr<gl::Context> context;
    std::unique_ptr<gl::Current> current;

  private:
    std::int64_t alive_before_ = 0;
};

} // namespace firsthit::test
