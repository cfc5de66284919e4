// point_shadows.cpp - shadows of points that are no pixels.
#include "shadow/point_shadows.h"

#include <algorithm>

namespace firsthit {
namespace {

constexpr std::size_t kChunk = 4096; // points

class GivenPoints : public LightPoints {
  public:
    GivenPoints(std::span<const glm::vec3> points, std::span<const std::uint32_t> receivers,
        const LightSpace& space)
        : points_(points),
          space_(space)
    {
        if (!receivers.empty()) item = receivers.data();
    }

    glm::vec3 in_light_space(std::uint32_t id) const override
    {
        return to_light(space_, points_[id]);
    }

  private:
    std::span<const glm::vec3> points_;
    const LightSpace& space_;
};

} // namespace

void test_points(const World& world, const LightSpace& space, std::span<const glm::vec3> points,
    std::span<const std::uint32_t> receivers, ShadowMemory& memory, Tasks& tasks,
    std::span<std::uint8_t> shadowed)
{
    const std::size_t chunks = (points.size() + kChunk - 1) / kChunk;
    resize(memory, chunks, kChunk, tasks.threads());
    see_from_light(space, world.position, world.scene->index, memory.mesh, tasks);
    tasks.for_each(chunks, [&](std::size_t number, std::size_t worker) {
        LightChunk& chunk = *memory.workers[worker];
        const std::size_t first = number * kChunk;
        chunk.count = std::min(kChunk, points.size() - first);
        for (std::size_t k = 0; k < chunk.count; ++k) {
            const glm::vec3 d = to_light(space, points[first + k]);
            chunk.x[k] = d.x, chunk.y[k] = d.y, chunk.z[k] = d.z;
            chunk.id[k] = std::uint32_t(first + k);
        }
        see_points(
            space, chunk, number * chunk_room(kChunk), memory.samples.span(), memory.parts[number]);
        std::fill_n(memory.shadowed.data() + first, kChunk, std::uint8_t(0));
    });
    test_chunks(GivenPoints(points, receivers, memory.mesh.space), memory, tasks);
    std::copy_n(memory.shadowed.data(), points.size(), shadowed.data());
}

} // namespace firsthit
