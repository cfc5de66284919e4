// embree_tree.cpp - Embree's bounding volume hierarchy of a posed world, which is updated frame by
// frame.
#include "baseline/embree_tree.h"

#include <firsthit/error.h>

#include <fmt/format.h>

namespace firsthit {
namespace {

/// The build quality of the scene. If it is low, Embree builds two-level trees that can be
/// refitted.
RTCBuildQuality scene_quality(BaselineUpdate update)
{
    switch (update) {
    case BaselineUpdate::rebuild_medium:
        return RTC_BUILD_QUALITY_MEDIUM;
    case BaselineUpdate::rebuild_high:
        return RTC_BUILD_QUALITY_HIGH;
    case BaselineUpdate::refit_instances:
    case BaselineUpdate::refit:
    case BaselineUpdate::rebuild_low:
        break;
    }
    return RTC_BUILD_QUALITY_LOW;
}

RTCBuildQuality geometry_quality(BaselineUpdate update)
{
    const bool refit = update == BaselineUpdate::refit || update == BaselineUpdate::refit_instances;
    return refit ? RTC_BUILD_QUALITY_REFIT : scene_quality(update);
}

} // namespace

EmbreeTree::EmbreeTree(const Scene& scene, BaselineUpdate update, int threads)
    : scene_(scene),
      update_(update)
{
    handles_.device = rtcNewDevice(fmt::format("threads={}", threads).c_str());
    if (!handles_.device) throw DeviceError("Embree has no device");
    handles_.scene = rtcNewScene(handles_.device);
    if (update != BaselineUpdate::rebuild_high)
        rtcSetSceneFlags(handles_.scene, RTC_SCENE_FLAG_DYNAMIC);
    rtcSetSceneBuildQuality(handles_.scene, scene_quality(update));
    handles_.check();
    packet_ =
        rtcGetDeviceProperty(handles_.device, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) ? 16 : 8;
}

EmbreeTree::~EmbreeTree()
{
    for (const Group& group : groups_) rtcReleaseGeometry(group.geometry);
}

void EmbreeTree::add(const World& world, std::size_t first_instance, std::size_t last_instance)
{
    const std::uint32_t first = scene_.instances[first_instance].first_triangle;
    const Instance& last = scene_.instances[last_instance - 1];
    const std::size_t count = std::size_t(last.first_triangle) + last.triangle_count - first;
    if (count == 0) return;
    RTCGeometry geometry = rtcNewGeometry(handles_.device, RTC_GEOMETRY_TYPE_TRIANGLE);
    groups_.push_back({first_instance, last_instance, count, geometry});
    first_triangle_.push_back(first);
    rtcSetGeometryBuildQuality(geometry, geometry_quality(update_));
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
        world.position.data(), 0, sizeof(glm::vec3), world.position.size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
        scene_.index.data() + first, 0, sizeof(glm::uvec3), count);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(handles_.scene, geometry);
    handles_.check();
}

void EmbreeTree::build(const World& world)
{
    for (const Group& group : groups_) rtcReleaseGeometry(group.geometry);
    for (std::size_t k = 0; k < groups_.size(); ++k) rtcDetachGeometry(handles_.scene, unsigned(k));
    groups_.clear();
    first_triangle_.clear();
    positions_ = nullptr; // in case an error is thrown
    instances_.assign(scene_.instances.size(), {});
    if (update_ == BaselineUpdate::refit_instances)
        for (std::size_t p = 0; p < scene_.instances.size(); ++p) add(world, p, p + 1);
    else if (!scene_.instances.empty())
        add(world, 0, scene_.instances.size());
    for (const Group& group : groups_) follow(world, group);
    rtcCommitScene(handles_.scene);
    handles_.check();
    positions_ = world.position.data();
}

bool EmbreeTree::follow(const World& world, const Group& group)
{
    bool moved = false;
    for (std::size_t p = group.first_instance; p < group.last_instance; ++p) {
        const Instance& instance = scene_.instances[p];
        const bool changes_shape = instance.changes_shape();
        const InstanceState state{.matrix = world.node_matrix[instance.node],
            .visible = world.node_visible[instance.node] != 0,
            .time_s = changes_shape ? world.time_s : 0};
        if (state == instances_[p]) continue;
        instances_[p] = state;
        moved = true;
    }
    return moved;
}

void EmbreeTree::assume_moved()
{
    instances_.assign(scene_.instances.size(), {}); // no matrix is all 0
}

std::uint64_t EmbreeTree::update(const World& world)
{
    if (positions_ != world.position.data()) {
        build(world);
        return scene_.triangle_count();
    }
    std::uint64_t updated = 0;
    for (const Group& group : groups_) {
        if (!follow(world, group)) continue;
        rtcUpdateGeometryBuffer(group.geometry, RTC_BUFFER_TYPE_VERTEX, 0);
        rtcCommitGeometry(group.geometry);
        updated += group.triangles;
    }
    if (updated == 0) return 0;
    rtcCommitScene(handles_.scene);
    handles_.check();
    return updated;
}

} // namespace firsthit
