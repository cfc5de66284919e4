// textures.h - the room's textures, made in code, with the same texels on every machine.
#pragma once

#include <firsthit/texture.h>

#include <glm/vec3.hpp>

#include <string>

namespace firsthit {

/// A floor of oak planks along u; covers 2.4 m.
Texture make_planks();
/// Wood whose grain runs along u; covers 1 m.
Texture make_wood(std::string name, const glm::vec3& color);
/// A wall that a brush has been over; covers 2 m.
Texture make_plaster(std::string name, const glm::vec3& color);
/// Woven cloth; covers 0.2 m.
Texture make_cloth(std::string name, const glm::vec3& color);
/// A rug, once from (0, 0) to (1, 1).
Texture make_rug();

/// How many bindings make_bindings() has, side by side along u.
inline constexpr int kBindings = 8;
/// The backs of books: binding k covers u from k / kBindings to (k + 1) / kBindings, v is 0 to 1 from the foot up.
Texture make_bindings();
/// A painting of hills under an evening sky.
Texture make_landscape();
/// A print of circles and stripes.
Texture make_poster();

} // namespace firsthit
