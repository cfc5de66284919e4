// depth_pass.h - draws shadow maps with OpenGL.
#pragma once

#include "gl/shadow/map_texels.h"
#include "gl/device/objects.h"
#include "gl/scene/scene_buffers.h"
#include "shadow/map/shadow_map.h"

#include <firsthit/scene.h>

#include <cstdint>
#include <span>

namespace firsthit::gl {

/// Draws the triangles in the view of a light's face, then stores their depths along the face's z
/// (shadow/map/shadow_map.h); +inf where there is no triangle.
///
/// limits  the driver decides which texels a triangle covers: it snaps corners, usually to 1/256 of
///         a texel
/// source  Williams 1978; Robert and Schoepke 2006, section 3.2
class DepthPass {
  public:
    DepthPass();

    /// Makes the map of a face from its source: fills in matrix, origin and offset, and the map's
    /// texels in `texels`, which must be laid out. Changes viewport, depth state, program and
    /// bindings of OpenGL.
    ///
    /// throws  DeviceError: no memory, or a map beyond the largest texture
    void draw(const World& world, const SceneBuffers& scene, const MapTexels& texels,
        const MapNumber& number, ShadowMaps& maps);

    /// The same for all maps in maps.changed.
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
