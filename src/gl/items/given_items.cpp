// given_items.cpp - items for the gpu engine that were made elsewhere.
#include "gl/items/given_items.h"

#include <firsthit/error.h>

#include <fmt/format.h>

namespace firsthit::gl {

ItemTexture GivenItems::draw(const World& /*world*/, const Pencil& pencil,
    const Settings& /*settings*/, const SceneBuffers& /*scene*/, Tasks& /*tasks*/)
{
    if (items_.size() != std::size_t(pencil.width) * std::size_t(pencil.height))
        throw DeviceError(fmt::format("{} items were given, and {}x{} are to be drawn",
            items_.size(), pencil.width, pencil.height));
    texture_.resize(GL_R32UI, pencil.width, pencil.height);
    glTextureSubImage2D(texture_.name(), 0, 0, 0, pencil.width, pencil.height, GL_RED_INTEGER,
        GL_UNSIGNED_INT, items_.data());
    return {texture_.name(), ItemFormat::r32ui};
}

} // namespace firsthit::gl
