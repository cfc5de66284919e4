// embree_tree.h - Embree's shadow rays, as benchmarks take them: 8-wide, coherent, default quality.
#pragma once

#include "irregular/mesh/pencil_mesh.h"
#include "irregular/mesh/project_points_to_face.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cstring>
#include <string>

namespace firsthit {

/// A tree over the triangles of a light's space. Built once; building is not measured.
class EmbreeTree {
  public:
    EmbreeTree(const PencilMesh& mesh, int threads)
        : device_(rtcNewDevice(("threads=" + std::to_string(threads)).c_str())),
          scene_(rtcNewScene(device_))
    {
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, mesh.corner.size() + 1));
        std::memcpy(vertex, mesh.corner.data(), mesh.corner.size() * 12);
        auto* index = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.index.size()));
        std::copy(mesh.index.begin(), mesh.index.end(), index);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    ~EmbreeTree()
    {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreeTree(const EmbreeTree&) = delete;
    EmbreeTree& operator=(const EmbreeTree&) = delete;

    /// shadowed[id] = 1 for the chunk's points that are. to_sky  null: from the light at the origin
    /// to the points; else from the points along it.
    void test(const PointChunk& chunk, const glm::vec3* to_sky, std::uint8_t* shadowed) const
    {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        for (std::size_t first = 0; first < chunk.count; first += 8) {
            alignas(32) RTCRay8 ray;
            alignas(32) int valid[8];
            for (std::size_t k = 0; k < 8; ++k) {
                const glm::vec3 p{chunk.x[first + k], chunk.y[first + k], chunk.z[first + k]};
                const glm::vec3 from = to_sky ? p : glm::vec3(0), along = to_sky ? *to_sky : p;
                valid[k] = first + k < chunk.count ? -1 : 0;
                ray.org_x[k] = from.x, ray.org_y[k] = from.y, ray.org_z[k] = from.z;
                ray.dir_x[k] = along.x, ray.dir_y[k] = along.y, ray.dir_z[k] = along.z;
                ray.tnear[k] = to_sky ? 1e-4f : 0.0f;
                ray.tfar[k] = to_sky ? 1e30f : 1 - 0x1p-16f;
                ray.time[k] = 0;
                ray.mask[k] = ~0u;
                ray.id[k] = 0;
                ray.flags[k] = 0;
            }
            rtcOccluded8(valid, scene_, &context, &ray);
            for (std::size_t k = 0; k < 8; ++k)
                if (valid[k] && ray.tfar[k] < 0) shadowed[chunk.id[first + k]] = 1;
        }
    }

  private:
    RTCDevice device_;
    RTCScene scene_;
};

} // namespace firsthit
