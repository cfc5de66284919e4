// objects.h - owners of OpenGL objects: made when first sized, deleted in time, counted.
//
// A context has to be current whenever one is sized, used or deleted; an empty one needs none. All
// are moved, never copied.
#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace firsthit::gl {

/// OpenGL objects of this process that these classes made and have not deleted yet.
std::int64_t gl_objects_alive();

/// The name of one object, 0 where there is none. Kind has make() and remove(name).
template <class Kind>
class Object {
  public:
    Object() = default;
    Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Object& operator=(Object&& other) noexcept
    {
        std::swap(name_, other.name_);
        return *this;
    }
    ~Object() { reset(); }

    GLuint name() const { return name_; }
    explicit operator bool() const { return name_ != 0; }

    void create()
    {
        reset();
        name_ = Kind::make();
    }
    void reset()
    {
        if (name_) Kind::remove(name_);
        name_ = 0;
    }

  private:
    GLuint name_ = 0;
};

struct BufferKind {
    static GLuint make();
    static void remove(GLuint name);
};
struct TextureKind {
    static GLuint make(); // two-dimensional
    static void remove(GLuint name);
};
struct BufferTextureKind {
    static GLuint make(); // of a buffer's elements
    static void remove(GLuint name) { TextureKind::remove(name); }
};
struct FramebufferKind {
    static GLuint make();
    static void remove(GLuint name);
};
struct VertexArrayKind {
    static GLuint make();
    static void remove(GLuint name);
};
struct ProgramKind {
    static GLuint make();
    static void remove(GLuint name);
};
struct ShaderKind { // a stage: created by program.cpp, which knows its type
    static GLuint make(GLenum type);
    static void remove(GLuint name);
};

/// Bytes that shaders and transfers use.
class Buffer {
  public:
    /// Room for that many bytes: grows, never shrinks; the content is undefined where it grew, and
    /// name() changes. 0 becomes 4, so that it can always be bound.
    ///
    /// flags  of glNamedBufferStorage. With GL_MAP_PERSISTENT_BIT it stays mapped: see mapped()
    /// throws  DeviceError: no memory
    void resize(std::size_t bytes, GLbitfield flags = GL_DYNAMIC_STORAGE_BIT);

    /// Copies bytes to an offset; needs GL_DYNAMIC_STORAGE_BIT.
    void upload(std::size_t offset, const void* data, std::size_t bytes);

    /// The whole content becomes `values`.
    template <class T>
    void assign(std::span<const T> values)
    {
        resize(values.size_bytes());
        upload(0, values.data(), values.size_bytes());
    }

    GLuint name() const { return object_.name(); }
    std::size_t size() const { return size_; } // bytes, as last asked for
    std::size_t capacity() const { return capacity_; }
    std::byte* mapped() const { return mapped_; } // null where it is not

    /// As shader storage block number `binding`, all of it.
    void bind_storage(GLuint binding) const;

  private:
    Object<BufferKind> object_;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
    std::byte* mapped_ = nullptr;
};

/// A picture of texels.
class Texture2D {
  public:
    /// Exactly that size; the content is undefined where format, size or levels are new. Then
    /// name() changes, and nearest, unrepeated lookups are set.
    /// throws  DeviceError: no memory
    void resize(GLenum format, int width, int height, int levels = 1);

    GLuint name() const { return object_.name(); }
    GLenum format() const { return format_; }
    int width() const { return width_; }
    int height() const { return height_; }
    int levels() const { return levels_; }

    void bind(GLuint unit) const;

  private:
    Object<TextureKind> object_;
    GLenum format_ = 0;
    int width_ = 0, height_ = 0, levels_ = 0;
};

/// A buffer as elements of a texture format: how shaders read arrays fastest, and without the size
/// limit of storage blocks.
class BufferTexture {
  public:
    /// All of the buffer, as it is now: again after it has grown.
    /// element_bytes  of the format
    /// throws  DeviceError: more elements than the driver's GL_MAX_TEXTURE_BUFFER_SIZE
    void look_at(const Buffer& buffer, GLenum format, std::size_t element_bytes);

    void bind(GLuint unit) const;

  private:
    Object<BufferTextureKind> object_;
};

/// What is drawn into.
class Framebuffer {
  public:
    /// texture 0: nothing at that point. level 0.
    void attach(GLenum point, GLuint texture);

    /// throws  DeviceError: the driver cannot draw into this; the message has its reason
    void check_complete(const char* what) const;

    GLuint name() const { return object_.name(); }

  private:
    Object<FramebufferKind> object_;
};

/// Where vertices come from; empty where shaders fetch them by gl_VertexID.
class VertexArray {
  public:
    void create() { object_.create(); }
    /// Of glDrawElements.
    void set_indices(const Buffer& index);
    GLuint name() const { return object_.name(); }

  private:
    Object<VertexArrayKind> object_;
};

/// Linked shaders: made by link_program (program.h).
class Program {
  public:
    void create() { object_.create(); }
    GLuint name() const { return object_.name(); }
    void use() const { glUseProgram(object_.name()); }

    /// -1 where the linker found no use for it; setting it then does nothing.
    GLint location(const char* uniform) const
    {
        return glGetUniformLocation(object_.name(), uniform);
    }

  private:
    Object<ProgramKind> object_;
};

/// Tells when the commands before it are done.
class Fence {
  public:
    Fence() = default;
    Fence(Fence&& other) noexcept : sync_(std::exchange(other.sync_, nullptr)) {}
    Fence& operator=(Fence&& other) noexcept
    {
        std::swap(sync_, other.sync_);
        return *this;
    }
    ~Fence() { reset(); }

    /// After all commands so far, which are sent to the driver.
    void insert();
    bool is_set() const { return sync_ != nullptr; }
    /// Whether they are done; does not wait. True where it is not set.
    bool is_done() const;
    /// Waits for them. Nothing to do where it is not set.
    /// throws  DeviceError: the driver failed, or took longer than a minute
    void wait(const char* what) const;
    void reset();

  private:
    GLsync sync_ = nullptr;
};

/// Counts what happens between begin and end.
class Query {
  public:
    /// target  GL_TIME_ELAPSED, GL_FRAGMENT_SHADER_INVOCATIONS_ARB, ...
    void begin(GLenum target);
    void end();
    /// Waits for the count.
    std::uint64_t result() const;
    GLuint name() const { return name_; }

    Query() = default;
    Query(Query&& other) noexcept
        : name_(std::exchange(other.name_, 0)),
          target_(std::exchange(other.target_, 0))
    {
    }
    Query& operator=(Query&& other) noexcept
    {
        std::swap(name_, other.name_);
        std::swap(target_, other.target_);
        return *this;
    }
    ~Query();

  private:
    GLuint name_ = 0;
    GLenum target_ = 0;
};

} // namespace firsthit::gl
