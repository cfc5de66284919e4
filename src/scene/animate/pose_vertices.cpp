// pose_vertices.cpp - where the vertices of a scene are at a time.
#include "scene/animate/pose_vertices.h"

#include "base/large_pages.h"
#include "scene/animate/pose_kernel.h"
#include "scene/animate/pose_nodes.h"
#include "scene/animate/skin_kernel.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>

namespace firsthit {
namespace {

// Vertices in a task: positions and normals of one stay in a core's second-level cache.
constexpr std::size_t kVerticesPerTask = 4096;
constexpr std::size_t kFacetsPerTask = 4096 / 3;

/// Vertices [first, last) of the scene, all of one instance.
struct Range {
    const Scene& scene;
    std::size_t instance; // its number
    std::size_t first;
    std::size_t last;

    const Instance& of() const { return scene.instances[instance]; }
    std::size_t count() const { return last - first; }
    std::size_t first_of_instance() const { return first - of().first_vertex; }
    const MeshShape* shape() const
    {
        return of().shape < 0 ? nullptr : &scene.shapes[static_cast<std::size_t>(of().shape)];
    }
};

/// Interpolates between the keys around the time, in object space.
void interpolate_keys(const Range& range, double time_s, glm::vec3* position, glm::vec3* normal)
{
    const std::vector<MorphKey>& keys = range.of().morph;
    std::size_t after = 0;
    while (after < keys.size() && keys[after].time_s <= time_s) ++after;
    const MorphKey& a = keys[after > 0 ? after - 1 : 0];
    const MorphKey& b = keys[std::min(after, keys.size() - 1)];
    const double span = b.time_s - a.time_s;
    const float u = span > 0 ? static_cast<float>((time_s - a.time_s) / span) : 0.0f;
    for (std::size_t k = 0; k < range.count(); ++k) {
        const std::size_t v = range.first_of_instance() + k;
        position[k] = (1 - u) * a.position[v] + u * b.position[v];
        normal[k] = (1 - u) * a.normal[v] + u * b.normal[v];
    }
}

/// Whether any morph target has a weight.
bool has_weights(const Range& range, const World& world)
{
    const MeshShape* shape = range.shape();
    if (!shape) return false;
    const float* weight =
        world.pose_memory.target_weight.data() + world.pose_memory.first_weight[range.instance];
    return std::any_of(weight, weight + shape->targets.size(), [](float w) { return w != 0; });
}

/// Adds what `displacement` names of every morph target, times its weight, in order of the targets.
void add_targets(const Range& range, const World& world,
    std::vector<glm::vec3> MorphTarget::*displacement, std::size_t stride, float* sum)
{
    const std::vector<MorphTarget>& targets = range.shape()->targets;
    const float* weight =
        world.pose_memory.target_weight.data() + world.pose_memory.first_weight[range.instance];
    for (std::size_t t = 0; t < targets.size(); ++t) {
        const std::vector<glm::vec3>& terms = targets[t].*displacement;
        if (weight[t] == 0 || terms.empty()) continue;
        const glm::vec3* term = terms.data() + range.first_of_instance();
        if (stride == 3) {
            add_weighted(weight[t], &term->x, 3 * range.count(), sum);
            continue;
        }
        for (std::size_t k = 0; k < range.count(); ++k)
            add_weighted(weight[t], &term[k].x, 3, sum + stride * k);
    }
}

/// Normals of posed triangles that have three vertices each; (0, 0, 1) where one has no area.
void make_facet_normals(const glm::vec3* position, std::size_t triangles, glm::vec3* normal)
{
    for (std::size_t k = 0; k < 3 * triangles; k += 3) {
        const glm::dvec3 a(position[k]);
        const glm::dvec3 cross =
            glm::cross(glm::dvec3(position[k + 1]) - a, glm::dvec3(position[k + 2]) - a);
        const double length = glm::length(cross);
        const glm::vec3 unit =
            length > 0 && std::isfinite(length) ? glm::vec3(cross / length) : glm::vec3(0, 0, 1);
        std::fill_n(normal + k, 3, unit);
    }
}

SkinnedVertices skin_of(const Range& range, World& world)
{
    const SkinWeights& weights = range.shape()->skin;
    const std::size_t first =
        range.first_of_instance() * static_cast<std::size_t>(weights.influences);
    const std::size_t joint =
        world.pose_memory.first_joint[static_cast<std::size_t>(range.of().skin)];
    return {joint_matrices(world.pose_memory) + 16 * joint, weights.influences,
        weights.joint.data() + first, weights.weight.data() + first};
}

bool is_skinned(const Range& range)
{
    return range.of().skin >= 0 && range.shape() && range.shape()->skin.influences > 0;
}

/// Unit tangents in world space; x where one has no direction left.
void pose_tangents(const Range& range, World& world)
{
    glm::vec4* tangent = world.tangent.data() + range.first;
    std::copy_n(range.scene.tangent.data() + range.first, range.count(), tangent);
    if (has_weights(range, world)) add_targets(range, world, &MorphTarget::tangent, 4, &tangent->x);
    if (is_skinned(range)) {
        skin_tangents(skin_of(range, world), range.count(), tangent, tangent);
        return;
    }
    const glm::dmat3 matrix(world.node_matrix[range.of().node]);
    const float sign = glm::determinant(matrix) < 0 ? -1.0f : 1.0f;
    for (std::size_t k = 0; k < range.count(); ++k) {
        const glm::dvec3 moved = matrix * glm::dvec3(tangent[k]);
        const double length = glm::length(moved);
        const bool good = length > 0 && std::isfinite(length);
        tangent[k] =
            glm::vec4(good ? glm::vec3(moved / length) : glm::vec3(1, 0, 0), sign * tangent[k].w);
    }
}

/// returns  whether the positions are finite
bool pose_range(const Range& range, World& world)
{
    const Scene& scene = range.scene;
    const Instance& instance = range.of();
    const glm::dmat4& world_from_instance = world.node_matrix[instance.node];
    glm::vec3* position = world.position.data() + range.first;
    glm::vec3* normal = world.normal.data() + range.first;
    const std::size_t count = range.count();
    if (!world.node_visible[instance.node]) {
        const glm::vec3 point(world_from_instance[3]);
        std::fill_n(position, count, point);
        std::fill_n(normal, count, glm::vec3(0, 0, 1));
        if (!world.tangent.empty())
            std::fill_n(world.tangent.data() + range.first, count, glm::vec4(1, 0, 0, 1));
        return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
    }
    if (!world.tangent.empty()) pose_tangents(range, world);

    const bool morphs = has_weights(range, world);
    const bool rigid = instance.morph.empty() && !instance.deform && !morphs;
    const glm::vec3* from = rigid ? scene.position.data() + range.first : position;
    const glm::vec3* from_normal = rigid ? scene.normal.data() + range.first : normal;
    if (instance.deform)
        instance.deform(world.time_s, range.first_of_instance(), range.first_of_instance() + count,
            position, normal);
    else if (!instance.morph.empty())
        interpolate_keys(range, world.time_s, position, normal);
    else if (morphs) {
        std::copy_n(scene.position.data() + range.first, count, position);
        std::copy_n(scene.normal.data() + range.first, count, normal);
        add_targets(range, world, &MorphTarget::position, 3, &position->x);
        add_targets(range, world, &MorphTarget::normal, 3, &normal->x);
    }
    bool finite;
    if (is_skinned(range))
        finite =
            skin_vertices(skin_of(range, world), count, {from, from_normal}, {position, normal});
    else
        finite = move_vertices(
            vertex_matrix(world_from_instance), count, {from, from_normal}, {position, normal});
    return finite;
}

} // namespace

std::size_t pose_vertices(const Scene& scene, World& world, Tasks& tasks)
{
    resize_in_large_pages(world.position, scene.vertices);
    resize_in_large_pages(world.normal, scene.vertices);
    world.tangent.resize(scene.tangent.size());
    const std::vector<Instance>& instances = scene.instances;
    std::atomic<std::size_t> first_bad = instances.size();
    // A task takes pieces of one or more instances, which it finds by their first vertex.
    tasks.for_ranges(scene.vertices, kVerticesPerTask, [&](std::size_t first, std::size_t last) {
        auto instance = std::upper_bound(instances.begin(), instances.end(), first,
            [](std::size_t vertex, const Instance& p) { return vertex < p.first_vertex; });
        for (--instance; first < last; ++instance) {
            const std::size_t end = std::min<std::size_t>(
                last, instance->first_vertex + std::size_t(instance->vertex_count));
            if (end <= first) continue;
            const auto number = static_cast<std::size_t>(instance - instances.begin());
            if (!pose_range({scene, number, first, end}, world)) {
                // The lowest one is named, whichever thread is first.
                std::size_t seen = first_bad.load();
                while (number < seen && !first_bad.compare_exchange_weak(seen, number)) {
                }
            }
            first = end;
        }
    });
    for (const Instance& facets : instances) {
        if (!facets.facet_normals || !world.node_visible[facets.node]) continue;
        tasks.for_ranges(
            facets.vertex_count / 3, kFacetsPerTask, [&](std::size_t first, std::size_t last) {
                const std::size_t vertex = facets.first_vertex + 3 * first;
                make_facet_normals(
                    world.position.data() + vertex, last - first, world.normal.data() + vertex);
            });
    }
    return first_bad;
}

} // namespace firsthit
