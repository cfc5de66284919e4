// shadow_map_bench.cpp - shadow maps of one light against Embree's 8-wide coherent occlusion rays for
// the same hits: same process, in turn, medians, milliseconds.
//
//     shadow_map_bench [--threads N] [--rounds N] [--size N] [--filter N] [--light KIND]
//         [--pictures PREFIX] [SCENE[@SECONDS] ...]
//
// KIND is scene (the scene's first light, the default), spot or directional: from the same place
// towards what is seen. Embree's tree is built beforehand and not counted; its rays start at the
// light, or at the hit where it is directional, and keep 1e-4 of their length or of the hit's depth
// away from it; the item's own triangle does not count.
#include "base/stopwatch.h"
#include "base/tasks.h"
#include "hits/hit_position.h"
#include "scene/pose.h"
#include "shadow/hit_picture.h"
#include "shadow/look_up.h"

#include <firsthit/firsthit.h>

#include <embree3/rtcore.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

namespace firsthit {
namespace {

struct Options {
    int threads = 1;
    int rounds = 11;
    int size = 0;
    int filter = 1;
    std::string light = "scene";
    std::string pictures;
    std::vector<std::string> scenes;
};

double median(std::vector<double> values)
{
    std::nth_element(values.begin(), values.begin() + long(values.size() / 2), values.end());
    return values[values.size() / 2];
}

/// Occlusion rays of all hits, 4x2 samples a packet.
class Occlusion {
  public:
    explicit Occlusion(const World& world) : device_(rtcNewDevice("threads=1"))
    {
        scene_ = rtcNewScene(device_);
        RTCGeometry mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        positions_ = world.position;
        positions_.emplace_back(0.0f); // Embree reads 16 bytes of the last
        rtcSetSharedGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
            positions_.data(), 0, sizeof(glm::vec3), world.position.size());
        rtcSetSharedGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
            world.scene->index.data(), 0, sizeof(glm::uvec3), world.scene->index.size());
        rtcSetGeometryOccludedFilterFunction(mesh, skip_own);
        rtcCommitGeometry(mesh);
        rtcAttachGeometry(scene_, mesh);
        rtcReleaseGeometry(mesh);
        rtcCommitScene(scene_);
    }
    ~Occlusion()
    {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    Occlusion(const Occlusion&) = delete;

    void cast(const HitTile& hits, const Light& light, float* lit)
    {
        const bool parallel = light.kind == Light::Kind::directional;
        const glm::vec3 from(light.position), along(glm::normalize(light.direction));
        for (int start = 0; start < hits.size * hits.size; start += 8) {
            alignas(32) int valid[8];
            RTCRay8 ray{};
            for (int k = 0; k < 8; ++k) {
                const int offset = start + k, block = offset / kBlockSamples;
                valid[k] = hits.item[offset] != kNoItem ? -1 : 0;
                if (!valid[k]) continue;
                const int blocks_x = hits.size / kBlock;
                const glm::vec3 p = hit_position(hits.frame,
                    float(block % blocks_x * kBlock + block_x(offset % kBlockSamples)),
                    float(block / blocks_x * kBlock + block_y(offset % kBlockSamples)),
                    hits.t[offset]);
                const glm::vec3 org = parallel ? p : from, dir = parallel ? -along : p - org;
                ray.org_x[k] = org.x, ray.org_y[k] = org.y, ray.org_z[k] = org.z;
                ray.dir_x[k] = dir.x, ray.dir_y[k] = dir.y, ray.dir_z[k] = dir.z;
                ray.tnear[k] = parallel ? 1e-4f * hits.t[offset] : 0;
                ray.tfar[k] = parallel ? std::numeric_limits<float>::infinity() : 1 - 1e-4f;
                ray.mask[k] = ~0u;
                ray.id[k] = hits.item[offset];
            }
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
            rtcOccluded8(valid, scene_, &context, &ray);
            for (int k = 0; k < 8; ++k) lit[start + k] = ray.tfar[k] < 0 ? 0.0f : 1.0f;
        }
    }

  private:
    static void skip_own(const RTCFilterFunctionNArguments* arguments)
    {
        for (unsigned k = 0; k < arguments->N; ++k)
            if (arguments->valid[k] && RTCRayN_id(arguments->ray, arguments->N, k) ==
                                           RTCHitN_primID(arguments->hit, arguments->N, k))
                arguments->valid[k] = 0;
    }

    RTCDevice device_;
    RTCScene scene_;
    std::vector<glm::vec3> positions_;
};

void write_picture(const std::string& file, const test::HitPicture& picture,
    const std::vector<std::vector<float>>& lit)
{
    const int width = picture.view.pencil.width, height = picture.view.pencil.height;
    std::vector<unsigned char> grey(std::size_t(width) * std::size_t(height), 40);
    picture.for_hits([&](std::size_t tile, const HitTile& hits, int x, int y, int offset) {
        const int column = int(tile) % picture.view.tiles_x * hits.size + x;
        const int row = int(tile) / picture.view.tiles_x * hits.size + y;
        grey[std::size_t(row) * std::size_t(width) + std::size_t(column)] =
            static_cast<unsigned char>(90 + 160 * lit[tile][std::size_t(offset)]);
    });
    std::FILE* out = std::fopen(file.c_str(), "wb");
    if (!out) return;
    std::fprintf(out, "P5\n%d %d\n255\n", width, height);
    std::fwrite(grey.data(), 1, grey.size(), out);
    std::fclose(out);
}

void measure(const std::string& argument, const Options& options)
{
    const std::size_t at = argument.find('@');
    const double time_s = at == std::string::npos ? 0 : std::atof(argument.c_str() + at + 1);
    const Scene scene = load_scene(argument.substr(0, at));
    Tasks tasks(options.threads);
    World world;
    pose(scene, time_s, world, tasks);
    View view;
    view.camera = scene.camera ? world.camera : framing_camera(world);
    const std::array<glm::vec3, 2> box = bounds(world);
    const glm::dvec3 middle = 0.5 * (glm::dvec3(box[0]) + glm::dvec3(box[1]));
    world.lights.resize(1);
    if (options.light != "scene") {
        world.lights[0].kind =
            options.light == "spot" ? Light::Kind::spot : Light::Kind::directional;
        world.lights[0].direction = middle - world.lights[0].position;
        world.lights[0].outer_rad = 1.2;
    }

    const test::HitPicture picture(world, view, tasks);
    Occlusion embree(world);
    ShadowMaps maps;
    Settings settings;
    settings.shadow_map_size = options.size;
    settings.shadow_filter = options.filter;
    const std::size_t tiles = picture.tiles.size(), samples = 64 * 64;
    struct Line {
        alignas(64) float value[64 * 64];
    };
    std::vector<Line> ours(tiles), theirs(tiles);
    std::vector<Line> hot(std::size_t(options.threads)); // a frame's tile stays in cache
    std::vector<double> bounds_ms, map_ms, look_up_ms, total_ms, still_ms, embree_ms;
    for (int round = 0; round < options.rounds + 1; ++round) {
        if (round == 1) // warm
            for (auto* times : {&bounds_ms, &map_ms, &look_up_ms, &total_ms, &still_ms, &embree_ms})
                times->clear();
        maps.geometry.position.resize(0); // as if everything had moved
        Stopwatch watch;
        start_maps(world, tasks.threads(), maps);
        tasks.for_each(tiles, [&](std::size_t k, std::size_t worker) {
            add_hits(picture.tiles[k]->hits, maps, worker);
        });
        bounds_ms.push_back(watch.lap_ms());
        update_maps(world, settings, maps, tasks);
        map_ms.push_back(watch.lap_ms());
        tasks.for_each(tiles, [&](std::size_t k, std::size_t worker) {
            look_up(maps, world, picture.tiles[k]->hits, 0, hot[worker].value);
        });
        look_up_ms.push_back(watch.lap_ms());
        total_ms.push_back(bounds_ms.back() + map_ms.back() + look_up_ms.back());
        update_maps(world, settings, maps, tasks);
        still_ms.push_back(watch.lap_ms());
        tasks.for_each(tiles, [&](std::size_t k, std::size_t) {
            embree.cast(picture.tiles[k]->hits, world.lights[0], theirs[k].value);
        });
        embree_ms.push_back(watch.lap_ms());
    }
    for (std::size_t k = 0; k < tiles; ++k)
        look_up(maps, world, picture.tiles[k]->hits, 0, ours[k].value);

    std::vector<std::vector<float>> mine(tiles), his(tiles), difference(tiles);
    for (std::size_t k = 0; k < tiles; ++k) {
        mine[k].assign(ours[k].value, ours[k].value + samples);
        his[k].assign(theirs[k].value, theirs[k].value + samples);
        difference[k].assign(samples, 0.5f);
    }
    // Only where the light is on the eye's side: the rays cannot say.
    std::size_t hits = 0, darker = 0, lighter = 0, faces = 0;
    picture.for_hits([&](std::size_t k, const HitTile& tile, int x, int y, int offset) {
        ++hits;
        const glm::uvec3& c = scene.index[tile.item[offset]];
        const glm::dvec3 v0(world.position[c.x]);
        const glm::dvec3 n =
            glm::cross(glm::dvec3(world.position[c.y]) - v0, glm::dvec3(world.position[c.z]) - v0);
        const Light& light = world.lights[0];
        const glm::dvec3 to_light = light.kind == Light::Kind::directional
                                        ? -light.direction
                                        : light.position - glm::dvec3(hit_position(tile.frame,
                                                               float(x), float(y), tile.t[offset]));
        const std::size_t s = std::size_t(offset);
        if (glm::dot(n, to_light) * glm::dot(n, view.camera.eye - v0) <= 0) his[k][s] = 0;
        if (light.kind == Light::Kind::spot &&
            glm::dot(glm::normalize(-to_light), glm::normalize(light.direction)) <
                std::cos(light.outer_rad))
            his[k][s] = 0;
        darker += mine[k][s] < his[k][s];
        lighter += mine[k][s] > his[k][s];
        difference[k][s] = 0.5f + 0.5f * (mine[k][s] - his[k][s]);
    });
    for (const ShadowMap& map : maps.light[0].map) faces += map.width() > 0;
    const std::string name = argument.substr(argument.find_last_of('/') + 1);
    std::printf(
        "%-22s %8zu %8zu %5zu %8.2f %7.2f %7.2f %7.2f %8.2f %7.2f %8.2f %6.2f %7.3f%% %7.3f%%\n",
        name.c_str(), scene.triangle_count(), hits, faces, double(maps.texels) / 1e6,
        median(bounds_ms), median(map_ms), median(look_up_ms), median(total_ms), median(still_ms),
        median(embree_ms), median(embree_ms) / median(total_ms),
        100.0 * double(darker) / double(hits), 100.0 * double(lighter) / double(hits));
    std::fflush(stdout);
    if (options.pictures.empty()) return;
    write_picture(options.pictures + "map.pgm", picture, mine);
    write_picture(options.pictures + "rays.pgm", picture, his);
    write_picture(options.pictures + "difference.pgm", picture, difference);
}

} // namespace
} // namespace firsthit

int main(int count, char** words)
{
    firsthit::Options options;
    for (int k = 1; k < count; ++k) {
        const std::string word = words[k];
        const bool more = k + 1 < count;
        if (word == "--threads" && more)
            options.threads = std::atoi(words[++k]);
        else if (word == "--rounds" && more)
            options.rounds = std::max(1, std::atoi(words[++k]));
        else if (word == "--size" && more)
            options.size = std::atoi(words[++k]);
        else if (word == "--filter" && more)
            options.filter = std::max(1, std::atoi(words[++k]));
        else if (word == "--light" && more)
            options.light = words[++k];
        else if (word == "--pictures" && more)
            options.pictures = words[++k];
        else
            options.scenes.push_back(word);
    }
    if (options.scenes.empty())
        options.scenes = {"builtin:torus", "builtin:robots@2.5", "builtin:wave?n=100000"};
    std::printf("1024x1024, %d thread(s), %s, medians of %d, milliseconds\n", options.threads,
        firsthit::instruction_set().c_str(), options.rounds);
    std::printf("%-22s %8s %8s %5s %8s %7s %7s %7s %8s %7s %8s %6s %8s %8s\n", "scene", "triangles",
        "hits", "faces", "Mtexels", "bounds", "map", "look-up", "total", "still", "embree", "ratio",
        "darker", "lighter");
    try {
        for (const std::string& scene : options.scenes) firsthit::measure(scene, options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "shadow_map_bench: %s\n", error.what());
        return 1;
    }
}
