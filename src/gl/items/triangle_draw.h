// triangle_draw.h - all triangles of a scene as a pencil sees them, for the passes that make items.
#pragma once

#include "exact/pencil.h"
#include "gl/device/context.h"
#include "gl/device/objects.h"
#include "gl/scene/scene_buffers.h"

namespace firsthit::gl {

/// From directions of the pencil (eye space after the division by z) to -1 .. 1, where sample i of the
/// viewport has its centre at i + 1/2: x scale + shift.
struct SampleToClip {
    GLfloat scale[2];
    GLfloat shift[2];
};
SampleToClip sample_to_clip(const Pencil& pencil);

/// Draws with the program in use, whose attribute 0 is a corner in eye space, and gl_PrimitiveID the
/// triangle's number.
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
