// shadow_bench.cpp - the exact shadow pass of one frame against Embree's 8-wide coherent shadow
// rays for the same points: same process, frame by frame in turn, medians.
//
//     shadow_bench [--threads N] [--rounds N] [--size N] [SCENE[@SECONDS] ...]
//
// Embree's tree is built beforehand and not counted. Both sides are given only the hits whose
// surface faces the light; Embree is given their points in the light's space, 4x2 pixels a packet.
#include "base/stopwatch.h"
#include "base/tasks.h"
#include "cpu/frame.h"
#include "render/check_settings.h"
#include "scene/pose.h"
#include "shadow/collect_hits.h"
#include "shadow/exact_shadows.h"
#include "shadow/find_receivers.h"

#include <firsthit/firsthit.h>

#include <embree3/rtcore.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace firsthit {
namespace {

struct Options {
    int threads = 1;
    int rounds = 11;
    int size = 1024;
    std::vector<std::string> scenes;
};

double median(std::vector<double> values)
{
    std::nth_element(values.begin(), values.begin() + long(values.size() / 2), values.end());
    return values[values.size() / 2];
}

/// Embree's tree over the triangles in a light's space.
struct Tree {
    RTCDevice device;
    RTCScene scene;

    Tree(const LightMesh& mesh, int threads)
        : device(rtcNewDevice(("threads=" + std::to_string(threads)).c_str())),
          scene(rtcNewScene(device))
    {
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, mesh.corner.size() + 1));
        std::memcpy(vertex, mesh.corner.data(), mesh.corner.size() * 12);
        auto* index = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.index.size()));
        std::copy(mesh.index.begin(), mesh.index.end(), index);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene);
    }
    ~Tree()
    {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }

    /// shadowed[id] = 1 for the chunk's points that are.
    void test(const LightChunk& chunk, std::uint8_t* shadowed) const
    {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        for (std::size_t first = 0; first < chunk.count; first += 8) {
            alignas(32) RTCRay8 ray;
            alignas(32) int valid[8];
            for (std::size_t k = 0; k < 8; ++k) {
                valid[k] = first + k < chunk.count ? -1 : 0;
                ray.org_x[k] = ray.org_y[k] = ray.org_z[k] = 0;
                ray.dir_x[k] = chunk.x[first + k];
                ray.dir_y[k] = chunk.y[first + k];
                ray.dir_z[k] = chunk.z[first + k];
                ray.tnear[k] = 0;
                ray.tfar[k] = 1 - 0x1p-16f;
                ray.time[k] = 0;
                ray.mask[k] = ~0u;
                ray.id[k] = 0;
                ray.flags[k] = 0;
            }
            rtcOccluded8(valid, scene, &context, &ray);
            for (std::size_t k = 0; k < 8; ++k)
                if (valid[k] && ray.tfar[k] < 0) shadowed[chunk.id[first + k]] = 1;
        }
    }
};

void measure(const std::string& argument, const Options& options)
{
    const std::size_t at = argument.find('@');
    const double time_s = at == std::string::npos ? 0 : std::atof(argument.c_str() + at + 1);
    const Scene scene = load_scene(argument.substr(0, at));
    Tasks tasks(options.threads);
    World world;
    pose(scene, time_s, world, tasks);
    world.lights.resize(1);
    View view;
    view.width = view.height = options.size;
    view.camera = scene.camera ? world.camera : framing_camera(world);
    view = checked(view);

    FrameMemory memory;
    Film film;
    Stats stats;
    Settings settings;
    render_frame(world, view, settings, memory, tasks, film, stats);
    const std::size_t samples = std::size_t(memory.tiles[0].size * memory.tiles[0].size);
    const LightSpace space = light_space(world.lights[0], view.camera.eye);

    // The points of all tiles, for Embree.
    Tree tree(memory.lit.exact.mesh, options.threads);
    std::vector<std::unique_ptr<LightChunk>> chunks;
    std::vector<std::uint8_t> theirs(memory.tiles.size() * samples);
    for (std::size_t tile = 0; tile < memory.tiles.size(); ++tile) {
        chunks.push_back(std::make_unique<LightChunk>());
        chunks.back()->reserve(samples);
        std::vector<std::uint64_t> chosen(samples / 64);
        TileReceivers receivers;
        receivers.resize(samples);
        find_receivers(memory.lit.exact.mesh, memory.tiles[tile], chosen, receivers);
        collect_hits(memory.tiles[tile], receivers, space, nullptr, std::uint32_t(tile * samples),
            chosen.data(), *chunks.back());
    }

    std::vector<double> ours_ms, collect_ms, see_ms, sort_ms, test_ms, theirs_ms;
    ShadowEffort effort;
    for (int round = 0; round < options.rounds + 2; ++round) {
        if (round == 2)
            for (auto* times : {&ours_ms, &collect_ms, &see_ms, &sort_ms, &test_ms, &theirs_ms})
                times->clear();
        take_effort(memory.lit.exact);
        Stopwatch watch;
        test_exact_shadows(
            world, view.camera.eye, memory.tiles, memory.lit.exact, tasks, memory.lit.bits);
        ours_ms.push_back(watch.lap_ms());
        effort = take_effort(memory.lit.exact);
        collect_ms.push_back(effort.collect_ms);
        see_ms.push_back(effort.see_ms);
        sort_ms.push_back(effort.sort_ms);
        test_ms.push_back(effort.test_ms);
        std::fill(theirs.begin(), theirs.end(), std::uint8_t(0));
        watch.lap_ms();
        tasks.for_each(chunks.size(),
            [&](std::size_t tile, std::size_t) { tree.test(*chunks[tile], theirs.data()); });
        theirs_ms.push_back(watch.lap_ms());
    }
    std::size_t differ = 0, shadowed = 0;
    for (std::size_t k = 0; k < theirs.size(); ++k) {
        differ += theirs[k] != memory.lit.exact.shadowed[k];
        shadowed += memory.lit.exact.shadowed[k];
    }
    const std::string name = argument.substr(argument.find_last_of('/') + 1);
    std::printf(
        "%-22s %9zu %9zu %9zu %7.2f %7.2f %7.2f %7.2f %8.2f %8.2f %6.2f %7zu %9zu %9zu %7zu\n",
        name.c_str(), scene.triangle_count(), std::size_t(effort.points), shadowed,
        median(collect_ms), median(see_ms), median(sort_ms), median(test_ms), median(ours_ms),
        median(theirs_ms), median(theirs_ms) / median(ours_ms), differ,
        std::size_t(effort.counts.triangles), std::size_t(effort.counts.pairs),
        std::size_t(effort.counts.uncertain));
    std::fflush(stdout);
}

} // namespace
} // namespace firsthit

int main(int count, char** words)
{
    firsthit::Options options;
    for (int k = 1; k < count; ++k) {
        const std::string word = words[k];
        if (word == "--threads" && k + 1 < count)
            options.threads = std::atoi(words[++k]);
        else if (word == "--rounds" && k + 1 < count)
            options.rounds = std::max(1, std::atoi(words[++k]));
        else if (word == "--size" && k + 1 < count)
            options.size = std::atoi(words[++k]);
        else
            options.scenes.push_back(word);
    }
    if (options.scenes.empty())
        options.scenes = {"builtin:torus", "builtin:robots@2.5", "builtin:wave?n=10000",
            "builtin:wave?n=100000", "builtin:wave?n=1000000", "builtin:wave?n=10000000"};
    std::printf("%dx%d, %d thread(s), %s, medians of %d, milliseconds\n", options.size,
        options.size, options.threads, firsthit::instruction_set().c_str(), options.rounds);
    std::printf("%-22s %9s %9s %9s %7s %7s %7s %7s %8s %8s %6s %7s %9s %9s %7s\n", "scene",
        "triangles", "points", "shadowed", "collect", "see", "sort", "test", "ours", "Embree",
        "ratio", "differ", "set up", "pairs", "open");
    try {
        for (const std::string& scene : options.scenes) firsthit::measure(scene, options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "shadow_bench: %s\n", error.what());
        return 1;
    }
}
