// builtin.h - the scenes that the library makes itself.
#pragma once

#include <firsthit/scene.h>

#include <cstdint>
#include <string_view>

namespace firsthit {

/// Makes a scene by name: "torus", "robots", "room", "wave", "wave?n=1000000" (without "builtin:").
///
/// throws  ArgumentError that says what is accepted: an unknown name, an unknown or repeated
///         parameter, a value out of range
Scene make_builtin(std::string_view name);

/// A torus of 32 x 16 quads, 1,024 triangles, with smooth normals, lit and framed.
Scene make_torus();

/// Ten walking robots on a tiled ground, 10 s long, with a moving camera; 70,000 to 75,000
/// triangles.
Scene make_robots();

/// A furnished room, 20 s long: a toy car drives around the table, the camera moves; about 100,000 triangles,
/// six point lights in lamps and the sun through a window, mirrors, a chrome kettle and a glass. Its arrays and
/// keys have the same bits on every machine.
Scene make_room();

inline constexpr std::uint64_t kMinWave = 2;
inline constexpr std::uint64_t kMaxWave = 10'000'000;

/// A cloth that waves for 10 s. It is a grid of columns x rows quads of two triangles each, with
/// quads = ceil(triangles / 2), columns = floor(sqrt(quads)), rows = ceil(quads / columns). So it
/// has at least `triangles` triangles: exactly 2 for 2, 10,082 for 10,000, and never more than
/// 2 sqrt(triangles) + 2 above.
/// throws  ArgumentError unless kMinWave <= triangles <= kMaxWave
Scene make_wave(std::uint64_t triangles);

} // namespace firsthit
