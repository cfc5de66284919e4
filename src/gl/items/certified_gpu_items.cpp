// certified_gpu_items.cpp - exact items for the gpu engine.
#include "gl/items/certified_gpu_items.h"

#include "visibility/bin/project.h"

#include <utility>

namespace firsthit::gl {

ItemTexture CertifiedGpuItems::draw(const World& world, const Pencil& pencil,
    const Settings& /*settings*/, const SceneBuffers& scene, Tasks& tasks)
{
    certified_.draw(scene, pencil);
    const std::span<const ListedSample> uncertain = certified_.read_uncertain();
    if (!uncertain.empty()) {
        view_.pencil = pencil;
        view_.index = world.scene->index;
        project_vertices(world.position, view_, tasks);
        decided_.resize(uncertain.size());
        find_listed_items(view_, uncertain, lazy_, decided_.span(), tasks);
        certified_.write(uncertain, decided_.span());
    }
    uncertain_ += uncertain.size();
    return {certified_.items().name(), ItemFormat::r32ui};
}

std::uint64_t CertifiedGpuItems::take_uncertain()
{
    return std::exchange(uncertain_, 0);
}

} // namespace firsthit::gl
