// drawn_items.h - items for the gpu engine, drawn by OpenGL.
#pragma once

#include "gl/items/gpu_items.h"
#include "gl/items/item_pass.h"
#include "visibility/bin/view_memory.h"

namespace firsthit::gl {

/// Draws items in the settings' item and depth formats. For DepthFormat::fixed24 the CPU finds the
/// range of depths.
class DrawnItems : public GpuItems {
  public:
    /// throws  DeviceError: see link_program
    explicit DrawnItems(const Context& context) : pass_(context) {}

    /// throws  as ItemPass::draw
    ItemTexture draw(const World& world, const Pencil& pencil, const Settings& settings,
        const SceneBuffers& scene, Tasks& tasks) override;

  private:
    ItemPass pass_;
    ViewMemory view_; // eye space on the CPU
};

} // namespace firsthit::gl
