// triangle_draw.h - draws all triangles of a scene in a pencil's eye space, for the passes that
// make items.
#pragma once

#include "exact/pencil.h"
#include "gl/device/context.h"
#include "gl/device/objects.h"
#include "gl/scene/scene_buffers.h"

namespace firsthit::gl {

/// Maps directions of the pencil (eye space divided by z) to clip space, -1 to 1, so that sample i
/// has its centre at i + 1/2 of the viewport: clip = scale * direction + shift.
struct SampleToClip {
    GLfloat scale[2];
    GLfloat shift[2];
};
SampleToClip sample_to_clip(const Pencil& pencil);

/// Draws with the current program. Attribute kEyeAttribute is a corner in eye space; gl_PrimitiveID
/// is the number of the triangle.
class TriangleDraw {
  public:
    TriangleDraw();

    void draw(const SceneBuffers& scene);

  private:
    VertexArray vertices_;
};

/// throws  ArgumentError: a parallel pencil
///         DeviceError: one that is wider or higher than the driver's textures
void check_pencil(const Pencil& pencil, const ContextInfo& limits);

} // namespace firsthit::gl
