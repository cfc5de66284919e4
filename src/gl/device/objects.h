// objects.h - classes that own OpenGL objects.
//
// An object is created when it is first given a size. A context must be current when an object is
// sized, used or deleted; an empty one needs no context. All classes can be moved but not copied.
#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace firsthit::gl {

/// The number of OpenGL objects in this process that these classes have created and not yet
/// deleted.
std::int64_t gl_objects_alive();

/// Owns the name of one object; 0 if there is none. Kind has make() and remove(name).
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
    static GLuint make(); // shows the elements of a buffer
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
struct ShaderKind { // created by program.cpp, which knows the type of the stage
    static GLuint make(GLenum type);
    static void remove(GLuint name);
};

/// A buffer of bytes for shaders and transfers.
class Buffer {
  public:
    /// Sets the size in bytes. The memory grows but never shrinks. If it grows, the whole content
    /// becomes undefined and name() changes. A size of 0 becomes 4, so that the buffer can always
    /// be bound.
    ///
    /// flags   of glNamedBufferStorage. With GL_MAP_PERSISTENT_BIT the buffer stays mapped: see
    ///         mapped()
    /// throws  DeviceError: no memory
    void resize(std::size_t bytes, GLbitfield flags = GL_DYNAMIC_STORAGE_BIT);

    /// Copies bytes to an offset. The buffer must have GL_DYNAMIC_STORAGE_BIT.
    void upload(std::size_t offset, const void* data, std::size_t bytes);

    /// Resizes the buffer to `values` and copies them.
    template <class T>
    void assign(std::span<const T> values)
    {
        resize(values.size_bytes());
        upload(0, values.data(), values.size_bytes());
    }

    GLuint name() const { return object_.name(); }
    std::size_t size() const { return size_; } // bytes, of the last resize
    std::size_t capacity() const { return capacity_; }
    std::byte* mapped() const { return mapped_; } // null if it is not mapped

    /// Binds the whole buffer as shader storage block number `binding`.
    void bind_storage(GLuint binding) const;

  private:
    Object<BufferKind> object_;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
    std::byte* mapped_ = nullptr;
};

/// A two-dimensional texture.
class Texture2D {
  public:
    /// Sets format, size and levels. If one of them changes, the content becomes undefined, name()
    /// changes, and sampling is set to nearest and clamped to the edge.
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

/// A buffer texture: the elements of a buffer as texels. Shaders read arrays fastest this way, and
/// it does not have the size limit of storage blocks.
class BufferTexture {
  public:
    /// Shows the whole buffer. To be called again after the buffer has grown.
    /// element_bytes  bytes of a texel of the format
    /// throws  DeviceError: more elements than the driver's GL_MAX_TEXTURE_BUFFER_SIZE
    void look_at(const Buffer& buffer, GLenum format, std::size_t element_bytes);

    void bind(GLuint unit) const;

  private:
    Object<BufferTextureKind> object_;
};

/// A framebuffer: the textures that are drawn to.
class Framebuffer {
  public:
    /// Attaches level 0 of a texture; 0 detaches.
    void attach(GLenum point, GLuint texture);

    /// throws  DeviceError: the driver cannot draw to these textures; the message names the status
    void check_complete(const char* what) const;

    GLuint name() const { return object_.name(); }

  private:
    Object<FramebufferKind> object_;
};

/// The sources of vertices. Empty if shaders load them by gl_VertexID.
class VertexArray {
  public:
    void create() { object_.create(); }
    /// Sets the index buffer of glDrawElements.
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

    /// The location of a uniform; -1 if the linker removed it because nothing uses it. Setting
    /// location -1 has no effect.
    GLint location(const char* uniform) const
    {
        return glGetUniformLocation(object_.name(), uniform);
    }

  private:
    Object<ProgramKind> object_;
};

/// A fence: tells when the commands before it are done.
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

    /// Inserts the fence after all commands so far, and sends these to the driver.
    void insert();
    bool is_set() const { return sync_ != nullptr; }
    /// Whether these commands are done; does not wait. True if the fence is not set.
    bool is_done() const;
    /// Waits until they are done. Does nothing if the fence is not set.
    /// throws  DeviceError: the driver failed, or took longer than a minute
    void wait(const char* what) const;
    void reset();

  private:
    GLsync sync_ = nullptr;
};

/// A query: counts what OpenGL does between begin() and end().
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
