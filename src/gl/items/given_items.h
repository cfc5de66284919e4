// given_items.h - items for the gpu engine that were made elsewhere.
#pragma once

#include "gl/items/gpu_items.h"
#include "gl/device/objects.h"

#include <cstdint>
#include <span>

namespace firsthit::gl {

/// Uploads items that the caller provides. The context must be current when this is deleted.
class GivenItems final : public GpuItems {
  public:
    /// items  (height, width) of the next rectangle to draw; not copied
    void set(std::span<const std::uint32_t> items) { items_ = items; }

    /// throws  DeviceError: the rectangle is of another size, or no memory
    ItemTexture draw(const World& world, const Pencil& pencil, const Settings& settings,
        const SceneBuffers& scene, Tasks& tasks) override;

  private:
    std::span<const std::uint32_t> items_;
    Texture2D texture_;
};

} // namespace firsthit::gl
