// certified_gpu_items.h - exact items for the gpu engine.
#pragma once

#include "gl/items/certified_items.h"
#include "gl/items/gpu_items.h"
#include "visibility/lazy_items.h"
#include "visibility/bin/view_memory.h"

namespace firsthit::gl {

/// Makes exact items: OpenGL finds the items that it is certain of, and the CPU decides the others,
/// which are then written to the same texture. OpenGL also poses the vertices
/// (gl/scene/scene_buffers.h). If the driver rounds doubles correctly, the items are identical to
/// those of the cpu engine.
class CertifiedGpuItems final : public GpuItems {
  public:
    /// throws  DeviceError: see link_program
    explicit CertifiedGpuItems(const Context& context) : certified_(context) {}

    /// throws  as CertifiedItems::draw
    ItemTexture draw(const World& world, const Pencil& pencil, const Settings& settings,
        const SceneBuffers& scene, Tasks& tasks) override;

    /// The number of samples that the CPU has decided since the last call.
    std::uint64_t take_uncertain();

  private:
    CertifiedItems certified_;
    ViewMemory view_; // eye space on the CPU
    LazyMemory lazy_;
    std::uint64_t uncertain_ = 0;
};

} // namespace firsthit::gl
