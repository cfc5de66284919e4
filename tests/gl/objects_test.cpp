// objects_test.cpp - classes that own OpenGL objects.
#include "gl_context.h"
#include "message_of.h"

#include <array>
#include <cstring>

namespace firsthit {
namespace {

using Objects = test::OnContext;

TEST_F(Objects, AreCountedUntilTheyAreDeleted)
{
    const std::int64_t before = gl::gl_objects_alive();
    {
        gl::Buffer buffer;
        gl::Texture2D texture;
        gl::Framebuffer framebuffer;
        gl::Fence fence;
        gl::Query query;
        EXPECT_EQ(gl::gl_objects_alive(), before); // empty ones are nothing yet
        buffer.resize(16);
        texture.resize(GL_R32UI, 4, 4);
        framebuffer.attach(GL_COLOR_ATTACHMENT0, texture.name());
        fence.insert();
        query.begin(GL_SAMPLES_PASSED);
        query.end();
        EXPECT_EQ(gl::gl_objects_alive(), before + 5);
    }
    EXPECT_EQ(gl::gl_objects_alive(), before);
}

TEST_F(Objects, MoveTheirNames)
{
    gl::Buffer one;
    one.resize(16);
    const GLuint name = one.name();
    const std::int64_t alive = gl::gl_objects_alive();
    gl::Buffer two = std::move(one);
    EXPECT_EQ(two.name(), name);
    EXPECT_EQ(gl::gl_objects_alive(), alive);
}

TEST_F(Objects, BuffersGrowAndNeverShrink)
{
    gl::Buffer buffer;
    buffer.resize(1000);
    const GLuint name = buffer.name();
    buffer.resize(10);
    EXPECT_EQ(buffer.name(), name);
    EXPECT_EQ(buffer.size(), 10u);
    EXPECT_EQ(buffer.capacity(), 1000u);
    buffer.resize(2000);
    EXPECT_EQ(buffer.capacity(), 2000u);
}

TEST_F(Objects, MappedBuffersStayMapped)
{
    gl::Buffer buffer;
    buffer.resize(8, GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT);
    const std::array<std::uint32_t, 2> written{1234, 5678};
    std::memcpy(buffer.mapped(), written.data(), sizeof(written));
    std::array<std::uint32_t, 2> read{};
    glGetNamedBufferSubData(buffer.name(), 0, sizeof(read), read.data());
    EXPECT_EQ(read, written);
}

TEST_F(Objects, FencesAreDoneAfterWaiting)
{
    gl::Fence fence;
    EXPECT_TRUE(fence.is_done());
    fence.insert();
    fence.wait("testing");
    EXPECT_TRUE(fence.is_done());
}

TEST_F(Objects, TexturesLargerThanTheDriverTakesAreErrors)
{
    gl::Texture2D texture;
    const int width = 2 * context->info().max_texture_size;
    const std::string message =
        message_of<DeviceError>([&] { texture.resize(GL_R32UI, width, 4); });
    EXPECT_NE(message.find("making a texture"), std::string::npos) << message;
}

} // namespace
} // namespace firsthit
