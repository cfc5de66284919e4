// sky_bench.cpp - a million points against the directions of a sky: the irregular z-buffer against
// Embree's 8-wide coherent shadow rays, same process, direction by direction in turn.
//
//     sky_bench [--threads N] [--points N] [--directions N] [--random] [SCENE[@SECONDS] ...]
//
// Points lie on the triangles that look up, spread by area and moved off by a thousandth of the
// scene, in the order of the triangles; --random spreads them in the scene's box instead. Embree's
// tree is built beforehand and not counted. Both sides are told which way the points lie; Embree
// shoots from the points towards the sky.
#include "embree_tree.h"
#include "baselines.h"

#include "base/stopwatch.h"
#include "base/tasks.h"
#include "scene/animate/pose.h"
#include "scene/model/borrow.h"
#include "shadow/exact/point_shadows.h"

#include <firsthit/firsthit.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace firsthit {
namespace {

struct Options {
    int threads = 1;
    std::size_t points = 1'000'000;
    int directions = 145;
    bool random = false;
    std::vector<std::string> scenes;
};

std::vector<glm::vec3> make_points(const World& world, const Options& options)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(0, 1);
    const auto box = bounds(world);
    std::vector<glm::vec3> points;
    if (options.random) {
        for (std::size_t k = 0; k < options.points; ++k)
            points.push_back(
                box[0] + (box[1] - box[0]) * glm::vec3(unit(random), unit(random), unit(random)));
        return points;
    }
    const float lift = 1e-3f * glm::length(box[1] - box[0]);
    std::vector<double> sum; // of areas
    double total = 0;
    const auto normal = [&](const glm::uvec3& c) {
        return glm::cross(
            world.position[c.y] - world.position[c.x], world.position[c.z] - world.position[c.x]);
    };
    for (const glm::uvec3& c : world.scene->index) {
        const glm::vec3 n = normal(c);
        if (n.y > 0) total += double(glm::length(n));
        sum.push_back(total);
    }
    std::size_t triangle = 0;
    for (std::size_t k = 0; k < options.points; ++k) {
        while (sum[triangle] < total * (double(k) + 0.5) / double(options.points)) ++triangle;
        const glm::uvec3& c = world.scene->index[triangle];
        float u = unit(random), v = unit(random);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        points.push_back(world.position[c.x] * (1 - u - v) + world.position[c.y] * u +
                         world.position[c.z] * v + lift * glm::normalize(normal(c)));
    }
    return points;
}

/// Directions that the light goes, evenly over the sky (a Fibonacci spiral over the half sphere).
glm::dvec3 sky_direction(int k, int count)
{
    const double height = (k + 0.5) / count, angle = 2.399963229728653 * k;
    const double radius = std::sqrt(1 - height * height);
    return {-radius * std::cos(angle), -height, -radius * std::sin(angle)};
}

void measure(const std::string& argument, const Options& options)
{
    const SceneArgument asked(argument);
    const Scene scene = load_scene(asked.scene);
    Tasks tasks(options.threads);
    World world;
    pose(borrow(scene), asked.time_s, world, tasks);
    const std::vector<glm::vec3> points = make_points(world, options);

    // Embree in world space: a light at the origin.
    PencilMesh mesh;
    make_pencil_mesh(PencilSpace{}, world.position, scene.index, mesh, tasks);
    const EmbreeTree tree(mesh, options.threads);
    constexpr std::size_t kChunk = 4096;
    std::vector<std::unique_ptr<PointChunk>> chunks;
    for (std::size_t first = 0; first < points.size(); first += kChunk) {
        chunks.push_back(std::make_unique<PointChunk>());
        PointChunk& chunk = *chunks.back();
        chunk.reserve(kChunk);
        chunk.count = std::min(kChunk, points.size() - first);
        for (std::size_t k = 0; k < chunk.count; ++k) {
            const glm::vec3& p = points[first + k];
            chunk.x[k] = p.x, chunk.y[k] = p.y, chunk.z[k] = p.z;
            chunk.id[k] = std::uint32_t(first + k);
        }
    }

    Stopwatch order_watch;
    PointSet set;
    make_point_set(points, {}, true, set, tasks);
    const double order_ms = order_watch.lap_ms();
    ShadowMemory memory;
    std::vector<std::uint8_t> ours(points.size()), theirs(points.size());
    double ours_ms = order_ms, theirs_ms = 0;
    std::size_t differ = 0, shadowed = 0;
    for (int k = -1; k < options.directions; ++k) {
        Light sun;
        sun.kind = Light::Kind::directional;
        sun.direction = sky_direction(std::max(k, 0), options.directions);
        const PencilSpace space = light_space(sun, glm::dvec3(0));
        Stopwatch watch;
        test_points({world, space}, set, memory, tasks, ours);
        const double mine = watch.lap_ms();
        if (k == 0) take_effort(memory); // the first was to warm up
        std::fill(theirs.begin(), theirs.end(), std::uint8_t(0));
        const glm::vec3 to_sky(-glm::normalize(sun.direction));
        watch.lap_ms();
        tasks.for_each(chunks.size(),
            [&](std::size_t c, std::size_t) { tree.test(*chunks[c], &to_sky, theirs.data()); });
        const double baseline = watch.lap_ms();
        if (k < 0) continue;
        ours_ms += mine;
        theirs_ms += baseline;
        for (std::size_t p = 0; p < points.size(); ++p) {
            differ += ours[p] != theirs[p];
            shadowed += ours[p];
        }
    }
    const ShadowEffort effort = take_effort(memory);
    const double n = options.directions;
    std::printf("%-22s %9zu %9zu %5.1f%% %8.2f %8.2f %8.2f %8.2f %9.2f %9.2f %6.2f %7.4f%%\n",
        asked.name.c_str(), scene.triangle_count(), points.size(),
        100.0 * double(shadowed) / (n * double(points.size())), effort.collect_ms / n,
        effort.project_ms / n, effort.sort_ms / n, effort.test_ms / n, ours_ms / n, theirs_ms / n,
        theirs_ms / ours_ms, 100.0 * double(differ) / (n * double(points.size())));
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
        else if (word == "--points" && k + 1 < count)
            options.points = std::size_t(std::atoll(words[++k]));
        else if (word == "--directions" && k + 1 < count)
            options.directions = std::max(1, std::atoi(words[++k]));
        else if (word == "--random")
            options.random = true;
        else
            options.scenes.push_back(word);
    }
    if (options.scenes.empty()) options.scenes = {"builtin:robots@2.5", "builtin:wave?n=100000"};
    std::printf("%d directions, %d thread(s), %s, milliseconds a direction\n", options.directions,
        options.threads, firsthit::instruction_set().c_str());
    std::printf("%-22s %9s %9s %6s %8s %8s %8s %8s %9s %9s %6s %8s\n", "scene", "triangles",
        "points", "dark", "collect", "project", "sort", "test", "ours", "Embree", "ratio",
        "differ");
    try {
        for (const std::string& scene : options.scenes) firsthit::measure(scene, options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "sky_bench: %s\n", error.what());
        return 1;
    }
}
