// moving_scenes.h - meshes of which all vertices move, or a share of them.
#pragma once

#include <firsthit/scene.h>

#include <cstdint>

namespace firsthit::cli::bench {

/// The mesh, twisted about the vertical axis through its middle, to and fro: every vertex and normal is
/// new at every time. Rigid parts only; nodes keep their places.
Scene twisting(Scene mesh);

/// The scene with its first light, which moves a little, so that a shadow map has to be made anew for every frame.
/// A directional light stays.
Scene with_moving_lights(Scene scene);

/// A cloth of about as many triangles, of which the vertices of the last rows, `share` of all, move at
/// every time, and the others never. A part each.
/// share  0 to 1
Scene partly_moving_cloth(std::uint64_t triangles, double share);

} // namespace firsthit::cli::bench
