// embree_occluder.cpp - Embree 3 as a second oracle of shadows, and as the baseline in benchmarks.
#include "rays/embree_occluder.h"

#include "rays/embree_handles.h"

#include <firsthit/error.h>

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace firsthit {
namespace {

constexpr std::size_t kPacket = 8;
constexpr std::size_t kRange = 1024; // points of one task

/// The data of the filter function. Embree's context must be the first member, because the filter
/// gets only its address.
struct OccluderContext {
    RTCIntersectContext embree;
    const LightTriangles& triangles;
    const PencilSpace& space;
    std::span<const glm::vec3> points;
    std::span<const std::uint32_t> receivers; // or none

    /// Whether the triangle counts for the ray to points[point].
    bool accepts(unsigned triangle, unsigned point) const
    {
        if (!receivers.empty() && triangle == receivers[point]) return false;
        return !triangles.cutouts ||
               triangles.cutouts->is_there(triangle, weight_corners(space, triangles[triangle]),
                   pencil_ray(space, points[point]));
    }
};

/// Rejects hits of the triangle that the ray's point lies on, and of cut-outs where these are not
/// there.
void skip_others(const RTCFilterFunctionNArguments* arguments)
{
    const OccluderContext& context = *reinterpret_cast<const OccluderContext*>(arguments->context);
    for (unsigned k = 0; k < arguments->N; ++k) {
        if (arguments->valid[k] == 0) continue;
        const unsigned point = RTCRayN_id(arguments->ray, arguments->N, k);
        if (!context.accepts(RTCHitN_primID(arguments->hit, arguments->N, k), point))
            arguments->valid[k] = 0;
    }
}

} // namespace

struct EmbreeOccluder::Impl : EmbreeHandles {
    LightTriangles triangles;
    float before_all = 0; // less than the z of every corner

    /// Casts the rays of points [first, min(first + kPacket, last)).
    void cast_packet(const PencilSpace& space, std::span<const glm::vec3> points, std::size_t first,
        std::size_t last, float short_of, OccluderContext& context,
        std::span<std::uint8_t> shadowed) const
    {
        alignas(32) RTCRay8 rays;
        alignas(32) int valid[kPacket];
        for (std::size_t k = 0; k < kPacket; ++k) {
            const std::size_t point = std::min(first + k, last - 1);
            const glm::vec3& d = points[point];
            valid[k] = first + k < last && has_shadow_ray(space, d) ? -1 : 0;
            rays.org_x[k] = space.directional ? d.x : 0;
            rays.org_y[k] = space.directional ? d.y : 0;
            rays.org_z[k] = space.directional ? std::min(before_all, d.z) : 0;
            rays.dir_x[k] = space.directional ? 0 : d.x;
            rays.dir_y[k] = space.directional ? 0 : d.y;
            rays.dir_z[k] = space.directional ? 1 : d.z;
            rays.tnear[k] = 0;
            rays.tfar[k] = (space.directional ? d.z - rays.org_z[k] : 1.0f) * (1 - short_of);
            rays.time[k] = 0;
            rays.mask[k] = ~0u;
            rays.id[k] = unsigned(point);
            rays.flags[k] = 0;
        }
        rtcOccluded8(valid, scene, &context.embree, &rays);
        for (std::size_t k = 0; first + k < std::min(last, first + kPacket); ++k)
            shadowed[first + k] = valid[k] != 0 && rays.tfar[k] < 0; // tfar = -inf: occluded
    }
};

EmbreeOccluder::EmbreeOccluder(const LightTriangles& triangles, bool robust, int threads)
    : impl_(std::make_unique<Impl>())
{
    Impl& e = *impl_;
    e.triangles = triangles;
    e.device = rtcNewDevice(fmt::format("threads={}", threads).c_str());
    if (!e.device) throw DeviceError("Embree has no device");
    e.scene = rtcNewScene(e.device);
    rtcSetSceneFlags(e.scene, RTCSceneFlags((robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE) |
                                            RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    rtcSetSceneBuildQuality(e.scene, RTC_BUILD_QUALITY_MEDIUM);
    e.geometry = rtcNewGeometry(e.device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertex =
        static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(e.geometry, RTC_BUFFER_TYPE_VERTEX, 0,
            RTC_FORMAT_FLOAT3, sizeof(glm::vec3), triangles.corner.size() + 1));
    auto* index = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(e.geometry,
        RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3), triangles.index.size()));
    e.check();
    std::copy(triangles.corner.begin(), triangles.corner.end(), vertex);
    std::copy(triangles.index.begin(), triangles.index.end(), index);
    rtcCommitGeometry(e.geometry);
    rtcAttachGeometry(e.scene, e.geometry);
    rtcCommitScene(e.scene);
    e.check();
    for (const glm::vec3& p : triangles.corner)
        if (usable(p)) e.before_all = std::min(e.before_all, p.z);
    e.before_all -= 0.01f * std::abs(e.before_all);
}

EmbreeOccluder::~EmbreeOccluder() = default;

void EmbreeOccluder::test(const PencilSpace& space, std::span<const glm::vec3> points,
    std::span<const std::uint32_t> receivers, std::span<std::uint8_t> shadowed, Tasks& tasks,
    float short_of)
{
    tasks.for_ranges(points.size(), kRange, [&](std::size_t first, std::size_t last) {
        OccluderContext context{{}, impl_->triangles, space, points, receivers};
        rtcInitIntersectContext(&context.embree);
        context.embree.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        const Cutouts* const cutouts = impl_->triangles.cutouts;
        if (!receivers.empty() || (cutouts && cutouts->any())) context.embree.filter = skip_others;
        for (std::size_t k = first; k < last; k += kPacket)
            impl_->cast_packet(space, points, k, last, short_of, context, shadowed);
    });
}

} // namespace firsthit
