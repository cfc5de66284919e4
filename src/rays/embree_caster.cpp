// embree_caster.cpp - Embree 3 as a second oracle, and as the baseline in benchmarks.
#include "rays/embree_caster.h"

#include "rays/embree_handles.h"

#include <firsthit/error.h>
#include <firsthit/scene.h>

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace firsthit {

namespace {

/// The data of the filter function. Embree's context must be the first member, because the filter
/// gets only its address.
struct CasterContext {
    RTCIntersectContext embree;
    const EyeTriangles& triangles;
};

/// Rejects hits of cut-outs where these are not there.
void skip_holes(const RTCFilterFunctionNArguments* arguments)
{
    const CasterContext& context = *reinterpret_cast<const CasterContext*>(arguments->context);
    for (unsigned k = 0; k < arguments->N; ++k) {
        if (arguments->valid[k] == 0) continue;
        const glm::vec3 d(RTCRayN_dir_x(arguments->ray, arguments->N, k),
            RTCRayN_dir_y(arguments->ray, arguments->N, k),
            RTCRayN_dir_z(arguments->ray, arguments->N, k));
        const unsigned triangle = RTCHitN_primID(arguments->hit, arguments->N, k);
        if (!context.triangles.is_there(triangle, d)) arguments->valid[k] = 0;
    }
}

} // namespace

struct EmbreeCaster::Impl : EmbreeHandles {
    EyeTriangles triangles;
    bool has_cutouts() const { return triangles.cutouts && triangles.cutouts->any(); }

    float* vertex = nullptr; // Embree's own copy of the corners, 3 floats each

    void copy_corners(const EyeTriangles& of)
    {
        for (std::size_t v = 0; v < of.corner.size(); ++v)
            std::memcpy(vertex + 3 * v, &of.corner[v], 3 * sizeof(float));
    }
};

EmbreeCaster::EmbreeCaster(const EyeTriangles& triangles, bool robust, bool dynamic, int threads)
    : impl_(std::make_unique<Impl>())
{
    Impl& e = *impl_;
    e.triangles = triangles;
    e.device = rtcNewDevice(fmt::format("threads={}", threads).c_str());
    if (!e.device) throw DeviceError("Embree has no device");
    e.scene = rtcNewScene(e.device);
    unsigned flags = RTC_SCENE_FLAG_NONE;
    if (robust) flags |= RTC_SCENE_FLAG_ROBUST;
    if (dynamic) flags |= RTC_SCENE_FLAG_DYNAMIC;
    if (e.has_cutouts()) flags |= RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;
    rtcSetSceneFlags(e.scene, RTCSceneFlags(flags));
    rtcSetSceneBuildQuality(e.scene, dynamic ? RTC_BUILD_QUALITY_LOW : RTC_BUILD_QUALITY_MEDIUM);
    e.geometry = rtcNewGeometry(e.device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(
        e.geometry, dynamic ? RTC_BUILD_QUALITY_REFIT : RTC_BUILD_QUALITY_MEDIUM);
    e.vertex = static_cast<float*>(rtcSetNewGeometryBuffer(e.geometry, RTC_BUFFER_TYPE_VERTEX, 0,
        RTC_FORMAT_FLOAT3, 3 * sizeof(float), triangles.corner.size() + 1));
    auto* index = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(e.geometry,
        RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3), triangles.index.size()));
    e.check();
    e.copy_corners(triangles);
    std::copy(triangles.index.begin(), triangles.index.end(), index);
    rtcCommitGeometry(e.geometry);
    rtcAttachGeometry(e.scene, e.geometry);
    rtcCommitScene(e.scene);
    e.check();
}

EmbreeCaster::~EmbreeCaster() = default;

void EmbreeCaster::refit(const EyeTriangles& triangles)
{
    impl_->triangles = triangles;
    impl_->copy_corners(triangles);
    rtcUpdateGeometryBuffer(impl_->geometry, RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(impl_->geometry);
    rtcCommitScene(impl_->scene);
}

namespace {

constexpr int kPacketX = 4, kPacketY = 2;
constexpr int kTile = 16; // rays on a side of a tile; packets go tile by tile, for coherence

/// Casts the rays (x0, y0) to (x0 + 3, y0 + 1) of the pencil.
void cast_packet(RTCScene scene, RTCIntersectContext& context, const Pencil& pencil, int x0, int y0,
    std::span<std::uint32_t> items, std::span<float> t)
{
    alignas(32) RTCRayHit8 packet;
    alignas(32) int valid[8];
    for (int k = 0; k < 8; ++k) {
        const int x = x0 + k % kPacketX, y = y0 + k / kPacketX;
        valid[k] = x < pencil.width && y < pencil.height ? -1 : 0;
        packet.ray.org_x[k] = packet.ray.org_y[k] = packet.ray.org_z[k] = 0;
        const glm::vec3 direction = pencil.tile(0, 0).direction(x, y);
        packet.ray.dir_x[k] = direction.x;
        packet.ray.dir_y[k] = direction.y;
        packet.ray.dir_z[k] = direction.z;
        packet.ray.tnear[k] = 0;
        packet.ray.tfar[k] = std::numeric_limits<float>::infinity();
        packet.ray.time[k] = 0;
        packet.ray.mask[k] = ~0u;
        packet.ray.flags[k] = 0;
        packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
        packet.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect8(valid, scene, &context, &packet);
    for (int k = 0; k < 8; ++k) {
        if (!valid[k]) continue;
        const std::size_t at = std::size_t(y0 + k / kPacketX) * std::size_t(pencil.width) +
                               std::size_t(x0 + k % kPacketX);
        const bool hit = packet.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
        items[at] = hit ? packet.hit.primID[k] : kNoItem;
        if (!t.empty()) t[at] = packet.ray.tfar[k];
    }
}

} // namespace

void EmbreeCaster::cast(
    const Pencil& pencil, std::span<std::uint32_t> items, std::span<float> t, Tasks& tasks)
{
    const int tiles_x = (pencil.width + kTile - 1) / kTile;
    const int tiles_y = (pencil.height + kTile - 1) / kTile;
    tasks.for_each(std::size_t(tiles_x) * std::size_t(tiles_y), [&](std::size_t tile, std::size_t) {
        CasterContext context{{}, impl_->triangles};
        rtcInitIntersectContext(&context.embree);
        context.embree.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        if (impl_->has_cutouts()) context.embree.filter = skip_holes;
        const int left = int(tile) % tiles_x * kTile, top = int(tile) / tiles_x * kTile;
        for (int y = top; y < std::min(top + kTile, pencil.height); y += kPacketY)
            for (int x = left; x < std::min(left + kTile, pencil.width); x += kPacketX)
                cast_packet(impl_->scene, context.embree, pencil, x, y, items, t);
    });
}

} // namespace firsthit
