// hybrid_maps.h - shadow maps drawn by OpenGL, for the rays of the CPU.
#pragma once

#include "gl/device/context.h"
#include "gl/shadow/depth_pass.h"
#include "gl/items/hybrid_items.h"
#include "gl/shadow/map_texels.h"
#include "gl/scene/scene_buffers.h"
#include "shadow/map/map_maker.h"

#include <optional>

namespace firsthit::gl {

/// The map maker of the hybrid engine: draws the maps and transfers them to host memory.
///
/// source  Robert and Schoepke 2006, section 4.1
class HybridMaps final : public MapMaker {
  public:
    /// context  outlives this, and is current on no other thread during the destructor
    /// scene    of that context, with Detail::surfaces
    HybridMaps(const Context& context, const SceneBuffers& scene);
    ~HybridMaps() override;

    /// Whose thread make() uses; it outlives the frames.
    void set_items(HybridItems& items) { items_ = &items; }

    /// The scene has to be posed for the world: the items of the same frame are drawn first.
    /// throws  DeviceError: no memory, a map beyond the driver's limits, a lost context
    void make(const World& world, ShadowMaps& maps, Tasks& tasks) override;

  private:
    const Context& context_;
    const SceneBuffers& scene_;
    HybridItems* items_ = nullptr;
    std::optional<DepthPass> pass_; // while the context is there
    std::optional<MapTexels> texels_;
};

} // namespace firsthit::gl
