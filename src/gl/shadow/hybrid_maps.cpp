// hybrid_maps.cpp - shadow maps drawn by OpenGL for the hybrid engine.
#include "gl/shadow/hybrid_maps.h"

namespace firsthit::gl {

HybridMaps::HybridMaps(const Context& context, const SceneBuffers& scene)
    : context_(context),
      scene_(scene)
{
    const Current current(context_);
    pass_.emplace();
    texels_.emplace();
}

HybridMaps::~HybridMaps()
{
    const Current current(context_);
    texels_.reset();
    pass_.reset();
}

void HybridMaps::make(const World& world, ShadowMaps& maps, Tasks& tasks)
{
    if (maps.changed.empty()) return;
    items_->with_context([&] {
        texels_->lay_out(maps.light, context_.info().max_storage_bytes);
        pass_->draw_changed(world, scene_, *texels_, maps);
        for (const MapNumber& k : maps.changed)
            texels_->read(k.light, std::size_t(k.face), map_of(maps, k));
        check("reading shadow maps");
    });
    tasks.for_each(maps.changed.size(), [&](std::size_t k, std::size_t) {
        ShadowMap& map = map_of(maps, maps.changed[k]);
        find_farthest(map.depth.data(), map.width(), map.height(), map.farthest);
    });
}

} // namespace firsthit::gl
