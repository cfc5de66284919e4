// scene_buffers.h - a world's triangles on OpenGL: what never moves goes there once.
#pragma once

#include "exact/pencil.h"
#include "gl/device/context.h"
#include "gl/scene/kept_copy.h"
#include "gl/device/objects.h"
#include "gl/scene/pose_data.h"

#include <firsthit/scene.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace firsthit::gl {

/// What is kept of a scene beside positions in eye space.
enum class Detail {
    items,    // nothing: enough for item buffers and shadow maps
    surfaces, // world positions and normals, texture coordinates, each triangle's material
};

/// The scene's arrays on OpenGL, and its vertices posed by a compute pass. To be made, used and
/// deleted with its context current. All buffers can be bound as std430 blocks:
///
///   index     uint[3 T]   vertices of each triangle
///   eye       vec4[V]     the pencil's eye space: (f x, f y, z), x right, y down, z forward
///   world     vec4[V]     world position              } with Detail::surfaces
///   normal    vec4[V]     world normal, unit          }
///   uv        vec2[V]     or empty: see has_uv()      }
///   material  uint[T]     number of its material      }
///
/// Positions are computed as the CPU does, in the same order, eye space in double and rounded once:
/// where the driver rounds as it should, they have the same bits as the world's and
/// ViewMemory::corner.
///
/// Vertices of rigid parts are posed from the scene's own arrays by matrices; those of parts that
/// morph or deform are taken from the world, through memory that the driver reads directly (twice
/// their size, so that a frame can be written while the one before is read). Whether something has
/// changed is found out by comparing bytes with copies of the last frame.
class SceneBuffers {
  public:
    /// throws  DeviceError: see link_program
    SceneBuffers(const Context& context, Detail detail);

    /// Poses the world for the pencil: uploads what is new and moves the vertices.
    ///
    /// world   posed from *world.scene (see pose)
    /// throws  DeviceError: an array is too large for the driver, or no memory
    void pose(const World& world, const Pencil& pencil);

    /// As pose, but eye space is the CPU's (ViewMemory::corner) for sure.
    /// corner  (V) or more
    void lend_eye_space(
        const World& world, const Pencil& pencil, std::span<const glm::vec4> corner);

    const Buffer& index() const { return index_; }
    const Buffer& eye() const { return eye_; }
    const Buffer& world() const { return world_; }
    const Buffer& normal() const { return normal_; }
    const Buffer& uv() const { return uv_; }
    const Buffer& material() const { return material_; }
    bool has_uv() const { return has_uv_; }
    std::uint32_t triangles() const { return triangles_; }
    std::uint32_t vertices() const { return vertices_; }

    /// To OpenGL so far.
    std::uint64_t uploaded_bytes() const { return uploaded_bytes_; }
    /// Compute passes so far.
    std::uint64_t poses() const { return poses_; }

  private:
    /// World-space vertices of the parts that morph or deform, double-buffered.
    struct MovingRing {
        Buffer buffer;                 // segments of positions, then normals
        std::array<Fence, 2> was_read; // the last pass over each segment
        std::size_t segment = 0;       // that holds the newest
        std::size_t segment_bytes = 0;
        std::size_t normal_offset = 0; // in a segment
    };

    void check_sizes(const Scene& scene) const;
    bool upload_scene(const Scene& scene);
    bool upload_parts(const Scene& scene);
    bool upload_matrices(const World& world);
    bool upload_moving(const World& world);
    bool update(const World& world, const Pencil& pencil);
    void run_pose();
    template <class T>
    bool upload_new(std::span<const T> values, KeptCopy<T>& kept, Buffer& buffer);

    ContextInfo limits_;
    Detail detail_;
    Program program_;
    GLint vertices_location_ = -1, eye_point_location_ = -1, eye_row_location_ = -1;
    glm::dvec3 eye_point_{0}; // of the newest eye space
    glm::dmat3 eye_from_world_{0.0};

    Buffer index_, eye_, world_, normal_, uv_, material_;
    Buffer rest_position_, rest_normal_, part_of_, part_, matrix_;
    MovingRing ring_;
    std::uint32_t vertices_ = 0, triangles_ = 0;
    bool has_uv_ = false;
    bool eye_is_lent_ = false;

    KeptCopy<glm::vec3> kept_rest_position_, kept_rest_normal_, kept_moving_, kept_moving_normal_;
    KeptCopy<glm::vec4> kept_lent_;
    KeptCopy<glm::vec2> kept_uv_;
    KeptCopy<glm::uvec3> kept_index_;
    KeptCopy<std::uint32_t> kept_owner_;
    KeptCopy<PartData> kept_part_;

    std::vector<PartData> parts_;      // memory that is kept from frame to frame
    std::vector<MatrixData> matrices_; // as they are on OpenGL
    std::vector<std::uint32_t> scratch_;
    std::vector<glm::vec3> moving_position_, moving_normal_;
    std::uint64_t uploaded_bytes_ = 0;
    std::uint64_t poses_ = 0;
};

} // namespace firsthit::gl
