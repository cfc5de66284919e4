// materials.h - what the room's things are made of.
#pragma once

#include <firsthit/scene_builder.h>

#include <array>
#include <cstdint>

namespace firsthit {

/// Materials of the scene, by number.
struct RoomMaterials {
    std::uint32_t floor = 0, wall = 0, accent_wall = 0, ceiling = 0, white = 0;
    std::uint32_t walnut = 0, oak = 0, birch = 0;
    std::uint32_t rug = 0, fringe = 0, linen = 0, mustard = 0, cushion = 0;
    std::uint32_t wicker = 0, leaf = 0, bark = 0, soil = 0, clay = 0;
    std::uint32_t books = 0, paper = 0, landscape = 0, poster = 0;
    std::uint32_t porcelain = 0, blue_glaze = 0, tea = 0, apple = 0, orange = 0;
    std::uint32_t brass = 0, iron = 0, chrome = 0, mirror = 0, glass = 0;
    std::uint32_t shade = 0, bulb = 0, lantern_paper = 0;
    std::uint32_t car_red = 0, car_cream = 0, rubber = 0, headlight = 0;
    std::array<std::uint32_t, 4> toys{};
};

/// Adds them, and their textures.
RoomMaterials add_room_materials(SceneBuilder& builder);

} // namespace firsthit
