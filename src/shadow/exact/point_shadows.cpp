// point_shadows.cpp - exact shadows at arbitrary points.
#include "shadow/exact/point_shadows.h"

#include "base/stopwatch.h"
#include "shadow/exact/lift_points.h"

#include <algorithm>

namespace firsthit {
namespace {

constexpr std::size_t kChunk = 1024; // points; a small chunk is often hidden by one occluder

class GivenPoints : public PencilPoints {
  public:
    GivenPoints(const PointSet& points, const PencilMesh& mesh) : points_(points), mesh_(mesh)
    {
        if (!points.receivers.empty()) item = points.receivers.data();
    }

    glm::vec3 in_pencil_space(std::uint32_t id) const override
    {
        return lift_point(
            mesh_, item ? item[id] : kNoItem, to_light(mesh_.space, points_.given[id]));
    }

  private:
    const PointSet& points_;
    const PencilMesh& mesh_;
};

} // namespace

void test_points(const LitWorld& lit, const PointSet& points, ShadowMemory& memory, Tasks& tasks,
    std::span<std::uint8_t> shadowed)
{
    const World& world = lit.world;
    const PencilSpace& space = lit.space;
    const std::size_t count = points.given.size();
    const std::size_t chunks = (count + kChunk - 1) / kChunk;
    resize(memory, chunks, kChunk, tasks.threads());
    Stopwatch watch;
    memory.mesh.cutouts.find(*world.scene, kShadowOpacity);
    make_pencil_mesh(space, world.position, world.scene->index, memory.mesh, tasks);
    memory.effort.project_ms += watch.lap_ms();
    tasks.for_each(chunks, [&](std::size_t number, std::size_t worker) {
        PointChunk& chunk = memory.workers[worker]->chunk;
        const std::size_t first = number * kChunk;
        chunk.count = std::min(kChunk, count - first);
        std::fill_n(shadowed.data() + first, chunk.count, std::uint8_t(0));
        move_points(points, space, first, chunk);
        if (!points.receivers.empty()) lift_points(memory.mesh, points.receivers.data(), 0, chunk);
        project_points_to_face(memory.mesh, chunk, number * chunk_room(kChunk),
            memory.samples.span(), memory.face_patches[number]);
    });
    memory.effort.collect_ms += watch.lap_ms();
    test_chunks(GivenPoints(points, memory.mesh), memory, tasks, shadowed);
}

} // namespace firsthit
