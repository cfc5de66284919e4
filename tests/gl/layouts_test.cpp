// layouts_test.cpp - drivers put the fields of gl/layouts.glsl and gl/pose_layout.glsl where C++
// has them.
#include "gl/device/program.h"
#include "gl/scene/gpu_data.h"
#include "gl_context.h"

#include <map>
#include <string>

namespace firsthit {
namespace {

using Offsets = std::map<std::string, std::size_t>; // by the name that OpenGL gives

template <class Struct>
void add_fields(const std::string& prefix, std::size_t at, Offsets& offsets)
{
    for (const gl::LayoutField& field : gl::LayoutOf<Struct>::kFields) {
        const std::string name = prefix + "." + std::string(field.name);
        if (field.type == "Rays")
            add_fields<Rays>(name, at + field.offset, offsets);
        else
            offsets[field.is_array ? name + "[0]" : name] = at + field.offset;
    }
}

template <class Struct>
void add_array(const std::string& name, std::size_t size, Offsets& offsets)
{
    for (std::size_t k = 0; k < size; ++k)
        add_fields<Struct>(name + "[" + std::to_string(k) + "]", k * sizeof(Struct), offsets);
}

/// The offsets that the driver gives the members of a program's blocks.
Offsets offsets_of(const gl::Program& program, GLenum interface)
{
    Offsets offsets;
    GLint count = 0;
    glGetProgramInterfaceiv(program.name(), interface, GL_ACTIVE_RESOURCES, &count);
    for (GLuint k = 0; k < GLuint(count); ++k) {
        char name[256] = {};
        glGetProgramResourceName(program.name(), interface, k, sizeof name, nullptr, name);
        const GLenum asked[] = {GL_BLOCK_INDEX, GL_OFFSET};
        GLint value[2] = {};
        glGetProgramResourceiv(program.name(), interface, k, 2, asked, 2, nullptr, value);
        if (value[0] >= 0) offsets[name] = std::size_t(value[1]);
    }
    return offsets;
}

GLint stride_of(const gl::Program& program, const char* name)
{
    const GLuint member = glGetProgramResourceIndex(program.name(), GL_BUFFER_VARIABLE, name);
    const GLenum asked = GL_TOP_LEVEL_ARRAY_STRIDE;
    GLint stride = 0;
    glGetProgramResourceiv(
        program.name(), GL_BUFFER_VARIABLE, member, 1, &asked, 1, nullptr, &stride);
    return stride;
}

/// A shader that reads all structs of layouts.glsl.
gl::Program shade_program(std::size_t few_lights)
{
    const gl::Defines defines = {{"FIRSTHIT_TEST", "0"}, {"FIRSTHIT_ITEM_CHANNELS", "1"},
        {"FIRSTHIT_SHADOW_MAPS", "1"}, {"FIRSTHIT_TEXTURES", "1"}, {"FIRSTHIT_SECOND_UV", "1"},
        {"FIRSTHIT_VERTEX_COLORS", "1"}, {"FIRSTHIT_TANGENTS", "1"}, {"FIRSTHIT_ONLY_MODEL", "-1"},
        {"FIRSTHIT_FEW_LIGHTS", std::to_string(few_lights)}};
    return gl::link_program({"screen.vert", "shade_hits.frag"}, defines);
}

using Layouts = test::OnContext;

/// Every member that the driver lists must be expected, with its offset.
void expect_offsets(const Offsets& found, const Offsets& expected)
{
    for (const auto& [name, offset] : found) {
        const auto known = expected.find(name);
        if (known == expected.end())
            ADD_FAILURE() << name << " is in no table";
        else
            EXPECT_EQ(offset, known->second) << name;
    }
}

TEST_F(Layouts, OfUniformBlocksAreThoseOfTheDriver)
{
    if (!context) return;
    const gl::Program program = shade_program(gl::kFewLights);
    Offsets expected;
    add_fields<gl::FrameData>("frame", 0, expected);
    add_array<gl::LightData>("light_data", gl::kFewLights, expected);
    add_array<gl::MapData>("map_data", gl::kFewLights * gl::kFaces, expected);
    const Offsets found = offsets_of(program, GL_UNIFORM);
    EXPECT_GE(found.size(), std::size(gl::LayoutOf<gl::FrameData>::kFields) + 10);
    expect_offsets(found, expected);

    const GLuint block = glGetProgramResourceIndex(program.name(), GL_UNIFORM_BLOCK, "Frame");
    const GLenum asked = GL_BUFFER_DATA_SIZE;
    GLint size = 0;
    glGetProgramResourceiv(program.name(), GL_UNIFORM_BLOCK, block, 1, &asked, 1, nullptr, &size);
    EXPECT_EQ(std::size_t(size), sizeof(gl::FrameData));
}

TEST_F(Layouts, OfStorageBlocksAreThoseOfTheDriver)
{
    if (!context) return;
    const gl::Program program = shade_program(0);
    Offsets expected;
    add_array<gl::LightData>("light_data", 1, expected);
    add_array<gl::MapData>("map_data", 1, expected);
    const Offsets found = offsets_of(program, GL_BUFFER_VARIABLE);
    EXPECT_GE(found.size(), 10u);
    expect_offsets(found, expected);
    EXPECT_EQ(std::size_t(stride_of(program, "light_data[0].color")), sizeof(gl::LightData));
    EXPECT_EQ(std::size_t(stride_of(program, "map_data[0].first")), sizeof(gl::MapData));
}

TEST_F(Layouts, OfPosingAreThoseOfTheDriver)
{
    if (!context) return;
    const gl::Program program = gl::link_program({"pose.comp"}, gl::Defines{{"SURFACES", "1"}});
    Offsets expected;
    add_array<gl::MatrixData>("matrix", 1, expected);
    add_array<gl::InstanceData>("instance", 1, expected);
    Offsets found = offsets_of(program, GL_BUFFER_VARIABLE);
    std::erase_if(found, [](const auto& member) { // arrays of numbers and vectors
        return member.first.find('.') == std::string::npos;
    });
    EXPECT_GE(found.size(), 5u); // those that the shader reads
    expect_offsets(found, expected);
    EXPECT_EQ(std::size_t(stride_of(program, "matrix[0].world[0]")), sizeof(gl::MatrixData));
    EXPECT_EQ(std::size_t(stride_of(program, "instance[0].first")), sizeof(gl::InstanceData));
}

} // namespace
} // namespace firsthit
