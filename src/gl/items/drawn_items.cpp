// drawn_items.cpp - items for the gpu engine, drawn by OpenGL.
#include "gl/items/drawn_items.h"

#include "gl/items/fit_depth.h"
#include "visibility/bin/project.h"

namespace firsthit::gl {

ItemTexture DrawnItems::draw(const World& world, const Pencil& pencil, const Settings& settings,
    const SceneBuffers& scene, Tasks& tasks)
{
    DepthRange range;
    if (settings.opengl.depth_format == DepthFormat::fixed24) {
        project_vertices(world.position, pencil, view_, tasks);
        range = fit_depth(view_.corner.span(), world.scene->index, pencil, tasks);
    }
    pass_.draw(scene, pencil, settings.opengl.item_format, settings.opengl.depth_format, range);
    return {pass_.items().name(), pass_.format()};
}

} // namespace firsthit::gl
