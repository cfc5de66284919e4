// scene_buffers.h - uploads a scene to OpenGL and poses its vertices there.
#pragma once

#include "exact/pencil.h"
#include "gl/device/context.h"
#include "gl/scene/kept_copy.h"
#include "gl/device/objects.h"
#include "gl/scene/gpu_data.h"

#include <firsthit/scene.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace firsthit::gl {

/// What is kept of a scene besides positions in eye space.
enum class Detail {
    items,    // nothing more: enough for item buffers
    surfaces, // world positions and normals, texture coordinates, each triangle's material
};

/// The arrays of a scene on OpenGL, and its vertices, which a compute pass poses. Arrays that do
/// not change are uploaded once. The context must be current when this is made, used and deleted.
/// All buffers can be bound as std430 blocks:
///
///   index     uint[3 T]   vertices of each triangle
///   eye       vec4[V]     the pencil's eye space: (f x, f y, z), x right, y down, z forward
///   world     vec4[V]     world position              } with Detail::surfaces
///   normal    vec4[V]     world normal, unit          }
///   uv        vec2[V]     empty without has_uv()      }
///   uv1       vec2[V]     empty without has_uv1()     }
///   color     vec4[V]     empty without has_color()   }
///   tangent   vec4[V]     empty without has_tangent() }
///   material  uint[T]     number of its material      }
///
/// Positions are computed with the same operations in the same order as on the CPU; eye space is
/// computed in double and rounded once. If the driver rounds correctly, they have the same bits as
/// World::position and ViewMemory::corner.
///
/// Vertices of rigid scene instances are posed by matrices from the scene's arrays. Vertices of instances
/// that morph or deform are copied from the world to mapped memory, which has room for two frames:
/// one is written while OpenGL reads the other. Arrays are uploaded again if their bytes differ
/// from copies of the last frame.
class SceneBuffers {
  public:
    /// throws  DeviceError: see link_program
    SceneBuffers(const Context& context, Detail detail);

    /// Poses the world for the pencil: uploads what has changed and computes the vertices.
    ///
    /// world   must be posed (see firsthit::pose)
    /// throws  DeviceError: an array is too large for the driver, or no memory
    void pose(const World& world, const Pencil& pencil);

    /// Like pose(), but the eye space is copied from the CPU.
    /// corner  (V) or more: ViewMemory::corner
    void lend_eye_space(
        const World& world, const Pencil& pencil, std::span<const glm::vec4> corner);

    const Buffer& index() const { return index_; }
    const Buffer& eye() const { return eye_; }
    const Buffer& world() const { return world_; }
    const Buffer& normal() const { return normal_; }
    const Buffer& uv() const { return uv_; }
    const Buffer& material() const { return material_; }
    const Buffer& uv1() const { return uv1_; }
    const Buffer& color() const { return color_; }
    const Buffer& tangent() const { return tangent_; }
    bool has_uv() const { return has_uv_; }
    bool has_uv1() const { return has_uv1_; }
    bool has_color() const { return has_color_; }
    bool has_tangent() const { return has_tangent_; }
    std::uint32_t triangles() const { return triangles_; }
    std::uint32_t vertices() const { return vertices_; }

    /// Bytes that were uploaded so far.
    std::uint64_t uploaded_bytes() const { return uploaded_bytes_; }
    /// Number of compute passes so far.
    std::uint64_t poses() const { return poses_; }

  private:
    /// World-space vertices of the instances that morph or deform, double-buffered.
    struct MovingRing {
        Buffer buffer;                 // segments of positions, then normals
        std::array<Fence, 2> was_read; // the last pass over each segment
        std::size_t segment = 0;       // the segment with the newest vertices
        std::size_t segment_bytes = 0;
        std::size_t normal_offset = 0; // in a segment
    };

    void check_sizes(const Scene& scene) const;
    bool upload_scene(const Scene& scene);
    bool upload_instances(const Scene& scene);
    bool upload_matrices(const World& world);
    bool upload_moving(const World& world);
    void upload_tangents(const World& world);
    bool update(const World& world, const Pencil& pencil);
    void run_pose();
    template <class T>
    bool upload_new(std::span<const T> values, KeptCopy<T>& kept, Buffer& buffer);

    ContextInfo limits_;
    Detail detail_;
    Program program_;
    GLint vertices_location_ = -1, eye_point_location_ = -1, eye_row_location_ = -1;
    glm::dvec3 eye_point_{0}; // origin of the current eye space
    glm::dmat3 eye_from_world_{0.0};

    Buffer index_, eye_, world_, normal_, uv_, material_, uv1_, color_, tangent_;
    Buffer rest_position_, rest_normal_, instance_of_, instance_, matrix_;
    MovingRing ring_;
    std::uint32_t vertices_ = 0, triangles_ = 0;
    bool has_uv_ = false, has_uv1_ = false, has_color_ = false, has_tangent_ = false;
    bool eye_is_lent_ = false;

    KeptCopy<glm::vec3> kept_rest_position_, kept_rest_normal_, kept_moving_, kept_moving_normal_;
    KeptCopy<glm::vec4> kept_lent_, kept_color_, kept_tangent_;
    KeptCopy<glm::vec2> kept_uv_, kept_uv1_;
    KeptCopy<glm::uvec3> kept_index_;
    KeptCopy<std::uint32_t> kept_owner_;
    KeptCopy<InstanceData> kept_instance_;

    std::vector<InstanceData> instances_; // memory that is kept from frame to frame
    std::vector<MatrixData> matrices_;    // the same as on OpenGL
    std::vector<std::uint32_t> scratch_;
    std::vector<glm::vec3> moving_position_, moving_normal_;
    std::uint64_t uploaded_bytes_ = 0;
    std::uint64_t poses_ = 0;
};

} // namespace firsthit::gl
