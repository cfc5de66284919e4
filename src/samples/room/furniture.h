// furniture.h - the things in the room; each function adds one kind to the scene.
//
// The floor is y = 0, 6 m along x and 5 m along z with the origin in its middle. The window is in the wall at
// x = -3, the shelf stands at the wall at z = -2.5.
#pragma once

#include "samples/room/room_scene.h"

namespace firsthit {

inline constexpr glm::dvec3 kRoomHalf{3.0, 1.35, 2.5};      // m
inline constexpr glm::dvec3 kTablePlace{-0.35, 0.0, -0.20}; // on the floor
inline constexpr double kTableTop = 0.74;                   // m above the floor

/// Floor, walls with the hole of the window, ceiling, beams, skirting boards, a door.
void add_walls(RoomScene& room);
/// Frame and bars of the window, its blind and curtains.
void add_window(RoomScene& room);
/// The rug under the table.
void add_rug(RoomScene& room);
/// The table.
void add_table(RoomScene& room);
/// Four chairs around it.
void add_chairs(RoomScene& room);
/// Kettle, cups, a glass, a bowl of fruit.
void add_crockery(RoomScene& room);
/// Wicker baskets: one on the table, one on the floor.
void add_baskets(RoomScene& room);
/// The shelf and its books.
void add_shelf(RoomScene& room);
/// The sideboard with drawers and handles.
void add_sideboard(RoomScene& room);
/// An armchair with cushions.
void add_armchair(RoomScene& room);
/// The plant in the corner.
void add_plant(RoomScene& room);
/// Mirrors, pictures and a clock.
void add_wall_things(RoomScene& room);
/// Lamps and the six lights in them.
void add_lamps(RoomScene& room);
/// Building blocks and a ball.
void add_toys(RoomScene& room);
/// The car that drives around the table once.
void add_car(RoomScene& room);

} // namespace firsthit
