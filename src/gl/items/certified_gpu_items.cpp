// certified_gpu_items.cpp - exact items for the gpu engine.
#include "gl/items/certified_gpu_items.h"

#include "visibility/bin/project.h"

#include <utility>

namespace firsthit::gl {

ItemTexture CertifiedGpuItems::draw(const World& world, const Pencil& pencil,
    const Settings& /*settings*/, const SceneBuffers& scene, Tasks& tasks)
{
    take_triangles(*world.scene, view_);
    certified_.draw(scene, pencil, view_.cutouts);
    const std::span<const ListedSample> uncertain = certified_.read_uncertain();
    if (!uncertain.empty()) {
        project_vertices(world.position, pencil, view_, tasks);
        certified_.write(uncertain, find_listed_items(pencil, view_, {uncertain}, lazy_, tasks));
    }
    uncertain_ += uncertain.size();
    return {certified_.items().name(), ItemFormat::r32ui};
}

std::uint64_t CertifiedGpuItems::take_uncertain()
{
    return std::exchange(uncertain_, 0);
}

} // namespace firsthit::gl
