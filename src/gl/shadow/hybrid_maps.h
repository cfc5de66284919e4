// hybrid_maps.h - shadow maps drawn by OpenGL for the hybrid engine.
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
    /// context  must outlive this, and must not be current on another thread during the destructor
    /// scene    of the same context, with Detail::surfaces
    HybridMaps(const Context& context, const SceneBuffers& scene);
    ~HybridMaps() override;

    /// make() runs on the thread of `items`, which must outlive the frames.
    void set_items(HybridItems& items) { items_ = &items; }

    /// The items of the same frame must have been drawn before, because that poses the scene.
    /// throws  DeviceError: no memory, a map beyond the driver's limits, a lost context
    void make(const World& world, ShadowMaps& maps, Tasks& tasks) override;

  private:
    const Context& context_;
    const SceneBuffers& scene_;
    HybridItems* items_ = nullptr;
    std::optional<DepthPass> pass_; // deleted while the context is current
    std::optional<MapTexels> texels_;
};

} // namespace firsthit::gl
