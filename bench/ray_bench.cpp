// ray_bench.cpp - single rays of any kind against Embree's, one by one: same rays, same process, in turn.
//
//     ray_bench [--repeats N] [--size N] [SCENE[@SECONDS] ...]
//
// Kinds of rays: those of a camera that frames the scene; the reflection of each at the normal of what it hits; one
// of a random direction into the half space above each hit, in random order ("diffuse"). One thread. The table has the
// median time of all rays, milliseconds of the thread's time, and how many nearest triangles differ from those of Embree's robust mode.
#include "baselines.h"

#include "base/tasks.h"
#include "exact/cutouts.h"
#include "rays/tree/cast_rays.h"
#include "scene/model/borrow.h"

#include <firsthit/firsthit.h>

#include <embree3/rtcore.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <random>
#include <string>
#include <vector>

namespace firsthit {
namespace {

/// Milliseconds that this thread has computed since the last call.
class ThreadWatch {
  public:
    double lap_ms()
    {
        timespec now{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
        const double ms = 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
        const double lap = ms - last_;
        last_ = ms;
        return lap;
    }

  private:
    double last_ = 0;
};

/// Embree's tree over world triangles.
class EmbreeRays {
  public:
    EmbreeRays(const World& world, bool robust)
        : device_(rtcNewDevice("threads=1")),
          scene_(rtcNewScene(device_))
    {
        if (robust) rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, world.position.size() + 1));
        std::memcpy(vertex, world.position.data(), world.position.size() * 12);
        const auto& index = world.scene->index;
        auto* corners = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, index.size()));
        std::copy(index.begin(), index.end(), corners);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    ~EmbreeRays()
    {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreeRays(const EmbreeRays&) = delete;
    EmbreeRays& operator=(const EmbreeRays&) = delete;

    /// No filter: rays of the benchmark have nothing to skip.
    void cast(const std::vector<Ray>& rays, std::vector<std::uint32_t>& id, bool coherent) const
    {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        if (coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        for (std::size_t k = 0; k < rays.size(); ++k) {
            const Ray& r = rays[k];
            RTCRayHit hit;
            hit.ray.org_x = r.origin.x, hit.ray.org_y = r.origin.y, hit.ray.org_z = r.origin.z;
            hit.ray.dir_x = r.direction.x, hit.ray.dir_y = r.direction.y,
            hit.ray.dir_z = r.direction.z;
            hit.ray.tnear = 0, hit.ray.tfar = r.t_max, hit.ray.time = 0;
            hit.ray.mask = ~0u, hit.ray.id = 0, hit.ray.flags = 0;
            hit.hit.geomID = hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(scene_, &context, &hit);
            id[k] = hit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? kNoItem : hit.hit.primID;
        }
    }

  private:
    RTCDevice device_;
    RTCScene scene_;
};

/// In the order of 8 x 8 blocks, as a picture is made.
std::vector<Ray> camera_rays(const World& world, int size)
{
    const Camera camera = framing_camera(world);
    const glm::dvec3 forward = glm::normalize(camera.direction),
                     right = glm::normalize(glm::cross(forward, camera.up)),
                     down = glm::cross(forward, right);
    const double focal = 0.5 * size / std::tan(0.5 * camera.fov_y_rad);
    std::vector<Ray> rays;
    for (int block = 0; block < size * size / 64; ++block)
        for (int k = 0; k < 64; ++k) {
            const int x = block % (size / 8) * 8 + k % 8, y = block / (size / 8) * 8 + k / 8;
            rays.push_back({glm::vec3(camera.eye),
                glm::vec3((x + 0.5 - 0.5 * size) * right + (y + 0.5 - 0.5 * size) * down +
                          focal * forward)});
        }
    return rays;
}

/// Rays that go on from the hits, a little above their surfaces.
std::vector<Ray> rays_from(
    const std::vector<Ray>& rays, const std::vector<RayHit>& hits, float scene_size, bool diffuse)
{
    std::mt19937 random(1);
    std::normal_distribution<float> normal_number;
    std::vector<Ray> next;
    for (std::size_t k = 0; k < rays.size(); ++k) {
        if (hits[k].triangle == kNoItem) continue;
        const glm::vec3 d = glm::normalize(rays[k].direction);
        const glm::vec3 n = glm::dot(hits[k].normal, d) > 0 ? -hits[k].normal : hits[k].normal;
        glm::vec3 to = d - 2 * glm::dot(d, n) * n;
        if (diffuse) {
            to = glm::normalize(
                glm::vec3(normal_number(random), normal_number(random), normal_number(random)));
            if (glm::dot(to, n) < 0) to = -to;
        }
        next.push_back(
            {rays[k].origin + hits[k].t * rays[k].direction + 1e-4f * scene_size * n, to});
    }
    if (diffuse) std::shuffle(next.begin(), next.end(), random);
    return next;
}

struct BenchScene {
    const CastTarget& ours;
    const EmbreeRays &fast, &robust;
};

void measure_rays(const std::string& name, const char* kind, const BenchScene& scene,
    const std::vector<Ray>& rays, int repeats)
{
    std::vector<RayHit> hits(rays.size());
    std::vector<std::uint8_t> any(rays.size());
    std::vector<std::uint32_t> fast(rays.size()), robust(rays.size());
    const bool coherent = kind != std::string("diffuse");
    std::vector<double> ms[4];
    for (int k = 0; k < repeats; ++k) {
        ThreadWatch watch;
        watch.lap_ms();
        cast_nearest(scene.ours, rays, hits);
        ms[0].push_back(watch.lap_ms());
        scene.robust.cast(rays, robust, coherent);
        ms[1].push_back(watch.lap_ms());
        scene.fast.cast(rays, fast, coherent);
        ms[2].push_back(watch.lap_ms());
        cast_any(scene.ours, rays, any);
        ms[3].push_back(watch.lap_ms());
    }
    std::size_t differ = 0, hit = 0;
    for (std::size_t k = 0; k < rays.size(); ++k) {
        differ += hits[k].triangle != robust[k];
        hit += hits[k].triangle != kNoItem;
    }
    std::printf("%-20s %-9s %8zu %5.1f%% %8.1f %8.1f %8.1f %8.1f %6.2f %8zu\n", name.c_str(), kind,
        rays.size(), 100.0 * double(hit) / double(std::max<std::size_t>(1, rays.size())),
        median(ms[0]), median(ms[3]), median(ms[1]), median(ms[2]), median(ms[1]) / median(ms[0]),
        differ);
    std::fflush(stdout);
}

void measure(const std::string& argument, int size, int repeats)
{
    const SceneArgument asked(argument);
    const Scene scene = load_scene(asked.scene);
    Tasks tasks(1);
    World world;
    pose(borrow(scene), asked.time_s, world);
    ThreadWatch watch;
    watch.lap_ms();
    RayTree tree;
    tree.build({world.position, scene.index}, tasks);
    const double build_ms = watch.lap_ms();
    tree.refit({world.position, scene.index}, tasks);
    const double refit_ms = watch.lap_ms();
    const EmbreeRays fast(world, false);
    const double embree_ms = watch.lap_ms();
    const EmbreeRays robust(world, true);
    Cutouts cutouts;
    cutouts.find(scene, kSeenOpacity);
    const CastTarget target{tree, scene, cutouts};
    std::printf("%s: %zu triangles, %zu nodes, %zu leaves; built in %.1f ms (Embree %.1f), "
                "refitted in %.2f\n",
        asked.name.c_str(), scene.triangle_count(), tree.nodes().size(), tree.blocks().size(),
        build_ms, embree_ms, refit_ms);
    const BenchScene all{target, fast, robust};
    const std::vector<Ray> first = camera_rays(world, size);
    measure_rays(asked.name, "camera", all, first, repeats);
    std::vector<RayHit> hits(first.size());
    cast_nearest(target, first, hits);
    const auto box = bounds(world);
    const float scene_size = glm::length(box[1] - box[0]);
    measure_rays(asked.name, "reflected", all, rays_from(first, hits, scene_size, false), repeats);
    measure_rays(asked.name, "diffuse", all, rays_from(first, hits, scene_size, true), repeats);
}

} // namespace
} // namespace firsthit

int main(int count, char** words)
{
    int size = 1024, repeats = 5;
    std::vector<std::string> scenes;
    for (int k = 1; k < count; ++k) {
        const std::string word = words[k];
        if (word == "--repeats" && k + 1 < count)
            repeats = std::max(1, std::atoi(words[++k]));
        else if (word == "--size" && k + 1 < count)
            size = std::max(8, std::atoi(words[++k]) / 8 * 8);
        else
            scenes.push_back(word);
    }
    if (scenes.empty()) scenes = {"builtin:robots@2.5"};
    std::printf("one thread, %s, milliseconds for all rays\n", firsthit::instruction_set().c_str());
    std::printf("%-20s %-9s %8s %6s %8s %8s %8s %8s %6s %8s\n", "scene", "rays", "number", "hit",
        "nearest", "any", "robust", "Embree", "ratio", "differ");
    try {
        for (const std::string& scene : scenes) firsthit::measure(scene, size, repeats);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "ray_bench: %s\n", error.what());
        return 1;
    }
}
