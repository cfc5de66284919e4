// program_test.cpp - compiling and linking shaders, and the errors of wrong ones.
#include "gl/device/program.h"

#include "gl_context.h"
#include "message_of.h"

#include <array>

namespace firsthit {
namespace {

using OfProgram = test::OnContext;

TEST_F(OfProgram, ComputesWhatTheSourceSays)
{
    gl::ShaderSource source{GL_COMPUTE_SHADER,
        "#version 450 core\nlayout(local_size_x = 1) in;\n"
        "layout(std430, binding = 0) buffer Out { uint value[]; };\n"
        "void main() { value[0] = 42u; }\n",
        {"test.comp"}};
    const gl::Program program = gl::link_source(source);
    gl::Buffer out;
    out.resize(4);
    out.bind_storage(0);
    program.use();
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    GLuint value = 0;
    glGetNamedBufferSubData(out.name(), 0, 4, &value);
    EXPECT_EQ(value, 42u);
    glUseProgram(0);
}

TEST_F(OfProgram, ErrorsNameShaderDriverAndLog)
{
    const std::string message = message_of<DeviceError>([] {
        gl::link_source({GL_FRAGMENT_SHADER,
            "#version 450 core\nvoid main() { int wrong = missing_name; }\n", {"bad.frag"}});
    });
    EXPECT_NE(message.find("0 = bad.frag"), std::string::npos) << message;
    EXPECT_NE(message.find(context->info().renderer), std::string::npos) << message;
    EXPECT_NE(message.find("missing_name"), std::string::npos) << message;
}

TEST(ShaderSource, NamesThatAreNotThereAreErrors)
{
    EXPECT_EQ(message_of<ArgumentError>([] { gl::shader_source("no.frag"); }),
        "there is no shader text 'no.frag'");
    EXPECT_EQ(message_of<ArgumentError>([] { gl::shader_source("phong.glsl"); }),
        "shader text 'phong.glsl' is no stage: .vert, .frag, .geom and .comp are accepted");
}

} // namespace
} // namespace firsthit
