// certified_gpu_items.h - exact items for the gpu engine.
#pragma once

#include "gl/items/certified_items.h"
#include "gl/items/gpu_items.h"
#include "visibility/lazy_items.h"
#include "visibility/bin/view_memory.h"

namespace firsthit::gl {

/// Items that OpenGL is certain of; the others are decided on the CPU and written between them. They
/// are the cpu engine's where the driver's doubles round as they should, for it poses the vertices
/// (gl/scene/scene_buffers.h).
class CertifiedGpuItems final : public GpuItems {
  public:
    /// throws  DeviceError: see link_program
    explicit CertifiedGpuItems(const Context& context) : certified_(context) {}

    /// throws  as CertifiedItems::draw
    ItemTexture draw(const World& world, const Pencil& pencil, const Settings& settings,
        const SceneBuffers& scene, Tasks& tasks) override;

    /// Samples that the CPU decided, since the last call.
    std::uint64_t take_uncertain();

  private:
    CertifiedItems certified_;
    ViewMemory view_; // eye space on the CPU
    LazyMemory lazy_;
    firsthit::Buffer<std::uint32_t> decided_;
    std::uint64_t uncertain_ = 0;
};

} // namespace firsthit::gl
