// triangle_draw.cpp - draws all triangles of a scene in a pencil's eye space, for the passes that
// make items.
#include "gl/items/triangle_draw.h"

#include "gl/bindings.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>

namespace firsthit::gl {

SampleToClip sample_to_clip(const Pencil& pencil)
{
    const double width = pencil.width, height = pencil.height;
    return {{GLfloat(2 / width), GLfloat(2 / height)},
        {GLfloat((1 - 2 * pencil.x0) / width - 1), GLfloat((1 - 2 * pencil.y0) / height - 1)}};
}

TriangleDraw::TriangleDraw()
{
    vertices_.create();
    glEnableVertexArrayAttrib(vertices_.name(), kEyeAttribute);
    glVertexArrayAttribFormat(vertices_.name(), kEyeAttribute, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(vertices_.name(), kEyeAttribute, 0);
}

void TriangleDraw::draw(const SceneBuffers& scene)
{
    glVertexArrayVertexBuffer(vertices_.name(), 0, scene.eye().name(), 0, sizeof(glm::vec4));
    vertices_.set_indices(scene.index());
    glBindVertexArray(vertices_.name());
    glDrawElements(GL_TRIANGLES, GLsizei(3 * scene.triangles()), GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
}

void check_pencil(const Pencil& pencil, const ContextInfo& limits)
{
    if (pencil.parallel) throw ArgumentError("items are drawn for rays through an eye only");
    if (std::max(pencil.width, pencil.height) > limits.max_texture_size)
        throw DeviceError(fmt::format("OpenGL: {}x{} samples are too many at once, {} on a side "
                                      "are possible ({}, {})",
            pencil.width, pencil.height, limits.max_texture_size, limits.renderer, limits.version));
}

} // namespace firsthit::gl
