// lift_points.cpp - lifts points off the triangles that they lie on.
#include "shadow/exact/lift_points.h"

#include <firsthit/scene.h>

#include <array>

namespace firsthit {
namespace {

/// A direct-mapped cache of receivers: points that follow each other lie on few triangles.
class Receivers {
  public:
    explicit Receivers(const PencilMesh& mesh) : mesh_(mesh) { item_.fill(kNoItem); }

    const Receiver& of(std::uint32_t item)
    {
        const std::size_t slot = item % kSlots;
        if (item_[slot] == item) return receiver_[slot];
        Effort effort;
        const Corners corners = mesh_.corners(item);
        item_[slot] = item;
        return receiver_[slot] = receiver_of(corners, light_side(mesh_.space, corners, effort));
    }

  private:
    static constexpr std::size_t kSlots = 256;
    const PencilMesh& mesh_;
    std::array<std::uint32_t, kSlots> item_;
    std::array<Receiver, kSlots> receiver_;
};

} // namespace

glm::vec3 lift_point(const PencilMesh& mesh, std::uint32_t item, const glm::vec3& d)
{
    if (item == kNoItem) return d;
    Effort effort;
    const Corners corners = mesh.corners(item);
    return lifted(mesh.space, d, receiver_of(corners, light_side(mesh.space, corners, effort)));
}

void lift_points(
    const PencilMesh& mesh, const std::uint32_t* items, std::uint32_t first_id, PointChunk& chunk)
{
    Receivers receivers(mesh);
    for (std::size_t k = 0; k < chunk.count; ++k) {
        const std::uint32_t item = items[chunk.id[k] - first_id];
        if (item == kNoItem) continue;
        const glm::vec3 d =
            lifted(mesh.space, {chunk.x[k], chunk.y[k], chunk.z[k]}, receivers.of(item));
        chunk.x[k] = d.x, chunk.y[k] = d.y, chunk.z[k] = d.z;
    }
}

} // namespace firsthit
