// depth_pass.h - shadow maps drawn by OpenGL.
#pragma once

#include "gl/shadow/map_texels.h"
#include "gl/device/objects.h"
#include "gl/scene/scene_buffers.h"
#include "shadow/map/shadow_map.h"

#include <firsthit/scene.h>

#include <cstdint>
#include <span>

namespace firsthit::gl {

/// Draws the triangles as a face of a light sees them, then stores their depths along the face's z
/// (shadow/map/shadow_map.h), +inf where nothing is.
///
/// limits  which texels a triangle covers is the driver's say: corners are snapped, mostly to 1/256
///         of a texel
/// source  Williams 1978; Robert and Schoepke 2006, section 3.2
class DepthPass {
  public:
    DepthPass();

    /// Makes the face's map from its source: fills in matrix, origin and offset, and its place in
    /// `texels`, which is laid out. Changes viewport, depth state, program and bindings.
    ///
    /// first   of the map's texels
    /// throws  DeviceError: no memory, or a map beyond the largest texture
    void draw(const World& world, const SceneBuffers& scene, int face, ShadowMap& map,
        std::uint32_t first, const MapTexels& texels);

    /// The same for all maps.changed.
    void draw_changed(
        const World& world, const SceneBuffers& scene, const MapTexels& texels, ShadowMaps& maps);

  private:
    Program draw_, store_;
    VertexArray triangles_;
    BufferTexture world_;
    Texture2D depth_; // as large as the largest map so far
    Framebuffer target_;
};

} // namespace firsthit::gl
