// sequence_frame.cpp - one frame of a sequence, and what is between two.
#include "readers/sequence/sequence_frame.h"

#include "readers/mesh/weld.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace firsthit {
namespace {

/// Two frames, and the vertices of both that an instance's vertices are between. Never changed: several
/// threads read it.
struct Between {
    std::shared_ptr<const Scene> a, b;
    double a_s = 0, b_s = 0;
    std::vector<glm::uvec2> vertex; // of a and of b, for each vertex of the instance

    void operator()(double time_s, std::size_t first, std::size_t last, glm::vec3* position,
        glm::vec3* normal) const
    {
        const auto u = static_cast<float>(std::clamp((time_s - a_s) / (b_s - a_s), 0.0, 1.0));
        for (std::size_t v = first; v < last; ++v, ++position, ++normal) {
            const std::size_t va = vertex[v].x, vb = vertex[v].y;
            const glm::vec3& pa = a->position[va];
            const glm::vec3& pb = b->position[vb];
            *position = pa == pb ? pa : (1 - u) * pa + u * pb; // what stands still keeps its bits
            const glm::vec3 sum = (1 - u) * a->normal[va] + u * b->normal[vb];
            const float length = glm::length(sum);
            // Opposite normals meet at 0.
            *normal = length > 1e-6f ? sum / length : a->normal[va];
        }
    }
};

/// The values of those vertices of frame a; nothing where there are none.
template <class T>
void append_values(
    const std::vector<T>& values, const std::vector<glm::uvec2>& vertices, std::vector<T>& to)
{
    if (values.empty()) return;
    for (const glm::uvec2& vertex : vertices) to.push_back(values[vertex.x]);
}

} // namespace

Scene scene_between(
    const SequenceFrame& a, const SequenceFrame& b, const CornerMap& map, double a_s, double b_s)
{
    const Scene& from = *a.scene;
    Scene scene = from;
    scene.position.clear();
    scene.normal.clear();
    scene.uv.clear();
    scene.uv1.clear();
    scene.color.clear();
    scene.tangent.clear();
    scene.vertices = 0;
    std::vector<VertexKey> pairs;
    Tasks alone(1);
    for (Instance& instance : scene.instances) {
        // A vertex for each pair of vertices, of both frames, that a corner has.
        pairs.clear();
        for (std::size_t t = instance.first_triangle;
             t < std::size_t(instance.first_triangle) + instance.triangle_count; ++t)
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t of_b = map.of(static_cast<std::uint32_t>(3 * t) + k);
                pairs.push_back({from.index[t][static_cast<int>(k)],
                    b.scene->index[of_b / 3][static_cast<int>(of_b % 3)]});
            }
        const Welded welded = weld(std::span<const VertexKey>(pairs), alone);

        Between between{a.scene, b.scene, a_s, b_s, {}};
        between.vertex.reserve(welded.first.size());
        for (const std::uint32_t first : welded.first)
            between.vertex.emplace_back(pairs[first][0], pairs[first][1]);
        append_values(from.uv, between.vertex, scene.uv);
        append_values(from.uv1, between.vertex, scene.uv1);
        append_values(from.color, between.vertex, scene.color);
        append_values(from.tangent, between.vertex, scene.tangent);

        const auto first_vertex = static_cast<std::uint32_t>(scene.vertices);
        for (std::size_t c = 0; c < pairs.size(); c += 3)
            scene.index[instance.first_triangle + c / 3] =
                glm::uvec3(welded.number[c], welded.number[c + 1], welded.number[c + 2]) +
                first_vertex;
        instance.first_vertex = first_vertex;
        instance.vertex_count = static_cast<std::uint32_t>(between.vertex.size());
        scene.vertices += between.vertex.size();
        instance.deform = std::move(between);
    }
    return scene;
}

} // namespace firsthit
