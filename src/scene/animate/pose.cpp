// pose.cpp - a scene at a time.
#include "scene/animate/pose.h"

#include "base/large_pages.h"
#include "base/tasks.h"
#include "scene/animate/pose_kernel.h"
#include "scene/animate/track.h"

#include <firsthit/error.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace firsthit {
namespace {

// Vertices in a task: positions and normals of one stay in a core's second-level cache.
constexpr std::size_t kVerticesPerTask = 4096;
constexpr std::size_t kNodesPerTask = 32;

std::string part_name(const Scene& scene, std::size_t part)
{
    const std::string& name = scene.parts[part].name;
    return "part " + std::to_string(part) + (name.empty() ? "" : " '" + name + "'");
}

[[noreturn]] void fail(const Scene& scene, const std::string& message)
{
    throw SceneError(scene.name + ": " + message);
}

void check_index(const Scene& scene, std::int64_t index, std::size_t size, const char* what)
{
    if (index >= static_cast<std::int64_t>(size))
        fail(scene, std::string(what) + " " + std::to_string(index) + " is out of range (" +
                        std::to_string(size) + " exist)");
}

/// What posing relies on. A few nanoseconds a part.
void check_shape(const Scene& scene)
{
    for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
        if (scene.nodes[n].parent >= static_cast<std::int64_t>(n))
            fail(scene, "node " + std::to_string(n) + " comes before its parent " +
                            std::to_string(scene.nodes[n].parent));
        check_index(scene, scene.nodes[n].track, scene.tracks.size(), "track");
    }
    for (const Light& light : scene.lights)
        check_index(scene, light.track, scene.tracks.size(), "track");
    check_index(scene, scene.camera_track, scene.tracks.size(), "track");

    std::size_t next = 0;
    for (std::size_t p = 0; p < scene.parts.size(); ++p) {
        const Part& part = scene.parts[p];
        check_index(scene, part.node, scene.nodes.size(), "node");
        if (part.first_vertex != next)
            fail(scene, part_name(scene, p) + " starts at vertex " +
                            std::to_string(part.first_vertex) + " instead of " +
                            std::to_string(next) + ": parts must follow each other without gaps");
        next += part.vertex_count;
        for (const MorphKey& key : part.morph)
            if (key.position.size() != part.vertex_count || key.normal.size() != part.vertex_count)
                fail(scene, part_name(scene, p) + " has a shape without all of its " +
                                std::to_string(part.vertex_count) + " vertices");
        const bool rigid = part.morph.empty() && !part.deform;
        if (rigid && part.vertex_count > 0 &&
            (next > scene.position.size() || next > scene.normal.size()))
            fail(scene, part_name(scene, p) + " lacks positions or normals");
    }
    if (next != scene.vertices)
        fail(scene, "the parts have " + std::to_string(next) + " vertices, the scene " +
                        std::to_string(scene.vertices));
}

void pose_nodes(const Scene& scene, double time_s, World& world, Tasks& tasks)
{
    world.node_matrix.resize(scene.nodes.size());
    world.node_visible.resize(scene.nodes.size());
    tasks.for_ranges(scene.nodes.size(), kNodesPerTask, [&](std::size_t first, std::size_t last) {
        for (std::size_t n = first; n < last; ++n) {
            const Node& node = scene.nodes[n];
            const Track* track =
                node.track < 0 ? nullptr : &scene.tracks[static_cast<std::size_t>(node.track)];
            world.node_matrix[n] = track ? evaluate(*track, time_s) : node.local;
            world.node_visible[n] = !track || is_visible(*track, time_s);
        }
    });
    // Parents come first.
    for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
        if (scene.nodes[n].parent < 0) continue;
        const auto parent = static_cast<std::size_t>(scene.nodes[n].parent);
        world.node_matrix[n] = world.node_matrix[parent] * world.node_matrix[n];
        world.node_visible[n] &= world.node_visible[parent];
    }
}

/// The part's own vertices [first, last) between its keys around the time, in object space.
void morph(const Part& part, double time_s, std::size_t first, std::size_t last,
    glm::vec3* position, glm::vec3* normal)
{
    const std::vector<MorphKey>& keys = part.morph;
    std::size_t after = 0;
    while (after < keys.size() && keys[after].time_s <= time_s) ++after;
    const MorphKey& a = keys[after > 0 ? after - 1 : 0];
    const MorphKey& b = keys[std::min(after, keys.size() - 1)];
    const double span = b.time_s - a.time_s;
    const float u = span > 0 ? static_cast<float>((time_s - a.time_s) / span) : 0.0f;
    for (std::size_t v = first; v < last; ++v) {
        position[v - first] = (1 - u) * a.position[v] + u * b.position[v];
        normal[v - first] = (1 - u) * a.normal[v] + u * b.normal[v];
    }
}

/// Vertices [first, last) of the scene, all of one part.
/// returns  whether they are finite
bool pose_vertices(
    const Scene& scene, const Part& part, std::size_t first, std::size_t last, World& world)
{
    const glm::dmat4& world_from_part = world.node_matrix[part.node];
    glm::vec3* position = world.position.data() + first;
    glm::vec3* normal = world.normal.data() + first;
    const std::size_t count = last - first;
    if (!world.node_visible[part.node]) {
        const glm::vec3 point(world_from_part[3]);
        std::fill_n(position, count, point);
        std::fill_n(normal, count, glm::vec3(0, 0, 1));
        return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
    }
    const VertexMatrix matrix = vertex_matrix(world_from_part);
    const bool rigid = part.morph.empty() && !part.deform;
    if (part.deform)
        part.deform(
            world.time_s, first - part.first_vertex, last - part.first_vertex, position, normal);
    else if (!rigid)
        morph(part, world.time_s, first - part.first_vertex, last - part.first_vertex, position,
            normal);
    return move_vertices(matrix, count, rigid ? scene.position.data() + first : position,
        rigid ? scene.normal.data() + first : normal, position, normal);
}

/// Parts are found by their first vertex; a task takes pieces of one or more.
void pose_parts(const Scene& scene, World& world, Tasks& tasks)
{
    resize_in_large_pages(world.position, scene.vertices);
    resize_in_large_pages(world.normal, scene.vertices);
    const std::vector<Part>& parts = scene.parts;
    std::atomic<std::size_t> first_bad = parts.size();
    tasks.for_ranges(scene.vertices, kVerticesPerTask, [&](std::size_t first, std::size_t last) {
        auto part = std::upper_bound(parts.begin(), parts.end(), first,
            [](std::size_t vertex, const Part& p) { return vertex < p.first_vertex; });
        for (--part; first < last; ++part) {
            const std::size_t end =
                std::min<std::size_t>(last, part->first_vertex + std::size_t(part->vertex_count));
            if (end <= first) continue;
            if (!pose_vertices(scene, *part, first, end, world)) {
                // The lowest one is named, whichever thread is first.
                const auto bad = static_cast<std::size_t>(part - parts.begin());
                std::size_t seen = first_bad.load();
                while (bad < seen && !first_bad.compare_exchange_weak(seen, bad)) {
                }
            }
            first = end;
        }
    });
    if (first_bad < parts.size())
        fail(scene, part_name(scene, first_bad) + " has a coordinate that is not finite at " +
                        std::to_string(world.time_s) + " s");
}

} // namespace

void pose(std::shared_ptr<const Scene> shared, double time_s, World& world, Tasks& tasks)
{
    if (!shared) throw ArgumentError("there is no scene to pose");
    if (!std::isfinite(time_s)) throw ArgumentError("the time of a pose must be a finite number");
    const Scene& scene = *shared;
    check_shape(scene);
    world.scene = std::move(shared);
    world.time_s = time_s;
    pose_nodes(scene, time_s, world, tasks);
    pose_parts(scene, world, tasks);

    world.lights = scene.lights;
    for (Light& light : world.lights) {
        if (light.track < 0 || light.kind == Light::Kind::directional) continue;
        const Track& track = scene.tracks[static_cast<std::size_t>(light.track)];
        if (!track.translation.empty()) light.position = evaluate_vector(track.translation, time_s);
    }

    const bool moves = scene.camera_track >= 0;
    world.camera = scene.camera ? *scene.camera : moves ? Camera{} : framing_camera(world);
    if (moves)
        world.camera = moved_camera(
            world.camera, scene.tracks[static_cast<std::size_t>(scene.camera_track)], time_s);
}

void pose(std::shared_ptr<const Scene> scene, double time_s, World& world, int threads)
{
    Tasks tasks(threads);
    pose(std::move(scene), time_s, world, tasks);
}

void pose(Scene&& scene, double time_s, World& world, int threads)
{
    pose(std::make_shared<const Scene>(std::move(scene)), time_s, world, threads);
}

} // namespace firsthit
