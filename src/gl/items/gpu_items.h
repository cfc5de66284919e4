// gpu_items.h - where the gpu engine's items come from.
#pragma once

#include "base/tasks.h"
#include "exact/pencil.h"
#include "gl/scene/scene_buffers.h"

#include <firsthit/settings.h>
#include <firsthit/scene.h>

namespace firsthit::gl {

/// A texture of items in one of the formats (gl/items/item_pass.h).
struct ItemTexture {
    GLuint name = 0;
    ItemFormat format = ItemFormat::r32ui;
};

/// Interface of the classes that make the items of a picture.
class GpuItems {
  public:
    GpuItems() = default;
    GpuItems(const GpuItems&) = delete;
    GpuItems& operator=(const GpuItems&) = delete;
    virtual ~GpuItems() = default;

    /// Makes the items of the pencil's rectangle, row 0 at the top, kNoItem for samples that see
    /// nothing.
    /// scene    must be posed for the pencil
    /// returns  a texture that is valid until the next call
    virtual ItemTexture draw(const World& world, const Pencil& pencil, const Settings& settings,
        const SceneBuffers& scene, Tasks& tasks) = 0;
};

} // namespace firsthit::gl
