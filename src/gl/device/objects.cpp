// objects.cpp - classes that own OpenGL objects.
#include "gl/device/objects.h"

#include "base/fresh_memory.h"
#include "gl/device/context.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>

namespace firsthit::gl {
namespace {

/// Objects that exist, of all contexts and threads. Tests find leaks by it.
std::atomic<std::int64_t> alive{0};

GLuint counted(GLuint name)
{
    if (name) ++alive;
    return name;
}

constexpr GLuint64 kLongestWait_ns = 60'000'000'000;

/// Like fill_fresh (base/fresh_memory.h), but random fills repeat the same bits in all elements.
void fill_fresh_buffer(GLuint name, std::size_t bytes)
{
    const FreshFill fill = fresh_fill.load(std::memory_order_relaxed);
    if (fill == FreshFill::none) return;
    std::uint32_t word;
    fill_memory(&word, sizeof word, fill);
    glClearNamedBufferSubData(name, GL_R32UI, 0, GLsizeiptr(bytes / sizeof word * sizeof word),
        GL_RED_INTEGER, GL_UNSIGNED_INT, &word);
    check("filling a buffer");
}

void fill_fresh_texture(GLuint name, GLenum format, int levels)
{
    const FreshFill fill = fresh_fill.load(std::memory_order_relaxed);
    if (fill == FreshFill::none) return;
    struct Texel {
        GLenum format, type;
    };
    const auto texel = [&]() -> Texel {
        switch (format) {
        case GL_R8UI:
        case GL_R32UI:
            return {GL_RED_INTEGER, GL_UNSIGNED_INT};
        case GL_RGBA32UI:
            return {GL_RGBA_INTEGER, GL_UNSIGNED_INT};
        case GL_DEPTH_COMPONENT24:
        case GL_DEPTH_COMPONENT32F:
            return {GL_DEPTH_COMPONENT, GL_FLOAT};
        case GL_RGB8:
        case GL_RGBA8:
            return {GL_RGBA, GL_UNSIGNED_BYTE};
        default:
            return {GL_RGBA, GL_FLOAT};
        }
    }();
    std::uint32_t words[4];
    fill_memory(words, sizeof words, fill);
    for (int level = 0; level < levels; ++level)
        glClearTexImage(name, level, texel.format, texel.type, words);
    check("filling a texture");
}

} // namespace

std::int64_t gl_objects_alive()
{
    return alive;
}

GLuint BufferKind::make()
{
    GLuint name = 0;
    glCreateBuffers(1, &name);
    return counted(name);
}

void BufferKind::remove(GLuint name)
{
    glDeleteBuffers(1, &name);
    --alive;
}

GLuint TextureKind::make()
{
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &name);
    return counted(name);
}

GLuint BufferTextureKind::make()
{
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_BUFFER, 1, &name);
    return counted(name);
}

void TextureKind::remove(GLuint name)
{
    glDeleteTextures(1, &name);
    --alive;
}

GLuint FramebufferKind::make()
{
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    return counted(name);
}

void FramebufferKind::remove(GLuint name)
{
    glDeleteFramebuffers(1, &name);
    --alive;
}

GLuint VertexArrayKind::make()
{
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    return counted(name);
}

void VertexArrayKind::remove(GLuint name)
{
    glDeleteVertexArrays(1, &name);
    --alive;
}

GLuint ProgramKind::make()
{
    return counted(glCreateProgram());
}

void ProgramKind::remove(GLuint name)
{
    glDeleteProgram(name);
    --alive;
}

GLuint ShaderKind::make(GLenum type)
{
    return counted(glCreateShader(type));
}

void ShaderKind::remove(GLuint name)
{
    glDeleteShader(name);
    --alive;
}

void Buffer::resize(std::size_t bytes, GLbitfield flags)
{
    bytes = std::max<std::size_t>(bytes, 4);
    if (bytes > capacity_) {
        capacity_ = size_ = 0;
        mapped_ = nullptr;
        object_.create();
        glNamedBufferStorage(object_.name(), GLsizeiptr(bytes), nullptr, flags);
        check("making a buffer");
        fill_fresh_buffer(object_.name(), bytes);
        if (flags & GL_MAP_PERSISTENT_BIT) {
            const GLbitfield access = flags & (GL_MAP_READ_BIT | GL_MAP_WRITE_BIT |
                                                  GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT);
            mapped_ = static_cast<std::byte*>(
                glMapNamedBufferRange(object_.name(), 0, GLsizeiptr(bytes), access));
            check("mapping a buffer");
            if (!mapped_)
                throw DeviceError(fmt::format(
                    "OpenGL: cannot map a buffer of {} bytes ({})", bytes, driver_name()));
        }
        capacity_ = bytes;
    }
    size_ = bytes;
}

void Buffer::upload(std::size_t offset, const void* data, std::size_t bytes)
{
    if (bytes > 0) glNamedBufferSubData(object_.name(), GLintptr(offset), GLsizeiptr(bytes), data);
}

void Buffer::bind_storage(GLuint binding) const
{
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, object_.name());
}

void Texture2D::resize(GLenum format, int width, int height, int levels)
{
    if (format == format_ && width == width_ && height == height_ && levels == levels_) return;
    format_ = 0;
    object_.create();
    glTextureStorage2D(object_.name(), levels, format, width, height);
    glTextureParameteri(object_.name(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(object_.name(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTextureParameteri(object_.name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(object_.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    check("making a texture");
    fill_fresh_texture(object_.name(), format, levels);
    format_ = format;
    width_ = width;
    height_ = height;
    levels_ = levels;
}

void Texture2D::bind(GLuint unit) const
{
    glBindTextureUnit(unit, object_.name());
}

void BufferTexture::look_at(const Buffer& buffer, GLenum format, std::size_t element_bytes)
{
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    const std::size_t elements = buffer.size() / element_bytes;
    if (elements > std::size_t(most))
        throw DeviceError(fmt::format("OpenGL: an array has {} elements, {} are possible ({})",
            elements, most, driver_name()));
    if (!object_) object_.create();
    glTextureBuffer(object_.name(), format, buffer.name());
}

void BufferTexture::bind(GLuint unit) const
{
    glBindTextureUnit(unit, object_.name());
}

void Framebuffer::attach(GLenum point, GLuint texture)
{
    if (!object_) object_.create();
    glNamedFramebufferTexture(object_.name(), point, texture, 0);
}

void Framebuffer::check_complete(const char* what) const
{
    const GLenum status = glCheckNamedFramebufferStatus(object_.name(), GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw DeviceError(fmt::format(
            "OpenGL: cannot draw {}: status 0x{:04X} ({})", what, status, driver_name()));
}

void VertexArray::set_indices(const Buffer& index)
{
    if (!object_) object_.create();
    glVertexArrayElementBuffer(object_.name(), index.name());
}

void Fence::insert()
{
    reset();
    sync_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (sync_) ++alive;
    glFlush();
}

bool Fence::is_done() const
{
    if (!sync_) return true;
    GLint state = GL_UNSIGNALED;
    glGetSynciv(sync_, GL_SYNC_STATUS, 1, nullptr, &state);
    return state == GL_SIGNALED;
}

void Fence::wait(const char* what) const
{
    if (!sync_) return;
    const GLenum answer = glClientWaitSync(sync_, GL_SYNC_FLUSH_COMMANDS_BIT, kLongestWait_ns);
    if (answer == GL_ALREADY_SIGNALED || answer == GL_CONDITION_SATISFIED) return;
    check(what);
    throw DeviceError(fmt::format("OpenGL: {} takes longer than {} s ({})", what,
        kLongestWait_ns / 1'000'000'000, driver_name()));
}

void Fence::reset()
{
    if (!sync_) return;
    glDeleteSync(sync_);
    --alive;
    sync_ = nullptr;
}

void Query::begin(GLenum target)
{
    if (name_ && target != target_) {
        glDeleteQueries(1, &name_);
        --alive;
        name_ = 0;
    }
    if (!name_) {
        glGenQueries(1, &name_); // glCreateQueries refuses pipeline statistics in Mesa 22
        counted(name_);
    }
    target_ = target;
    glBeginQuery(target, name_);
}

void Query::end()
{
    glEndQuery(target_);
}

std::uint64_t Query::result() const
{
    GLuint64 count = 0;
    glGetQueryObjectui64v(name_, GL_QUERY_RESULT, &count);
    return count;
}

Query::~Query()
{
    if (!name_) return;
    glDeleteQueries(1, &name_);
    --alive;
}

} // namespace firsthit::gl
