// hit_bounds.cpp - finds the bounds of the visible hits on the faces of each light.
#include "gl/shadow/hit_bounds.h"

#include "gl/bindings.h"
#include "gl/device/context.h"

#include <bit>

namespace firsthit::gl {
namespace {

constexpr std::size_t kNumbers = 5;

/// The float of a key: the inverse of key_of in hit_bounds.comp.
float float_of(std::uint32_t key)
{
    return std::bit_cast<float>(key & 0x80000000u ? key & 0x7FFFFFFFu : ~key);
}

FaceBounds face_bounds(const std::uint32_t* keys)
{
    if (keys[4] == 0) return {};
    return {float_of(~keys[0]), float_of(~keys[1]), float_of(keys[2]), float_of(keys[3]), keys[4]};
}

} // namespace

void HitBounds::find(const Program& program, glm::ivec2 size, std::span<LightBounds> bounds)
{
    const std::size_t numbers = bounds.size() * kFaces * kNumbers;
    if (numbers == 0) return;
    keys_.resize(numbers * 4);
    read_.resize(numbers);
    glClearNamedBufferData(keys_.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
    keys_.bind_storage(kResultBlock);
    program.use();
    const GLuint blocks = (GLuint(size.x + 7) / 8) * (GLuint(size.y + 7) / 8);
    glDispatchCompute((blocks + 31) / 32, 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(keys_.name(), 0, GLsizeiptr(numbers * 4), read_.data());
    check("finding what lights shine on");
    for (std::size_t light = 0; light < bounds.size(); ++light)
        for (std::size_t face = 0; face < kFaces; ++face)
            bounds[light][face] = face_bounds(&read_[(light * kFaces + face) * kNumbers]);
}

} // namespace firsthit::gl
