// film_size.h - sets the sizes of a film's planes.
#pragma once

#include <firsthit/film.h>

#include <cstddef>
#include <span>

namespace firsthit {

/// Sets the sizes of the planes that are asked for. Allocates only where the film grows.
/// lights  number of lights of the world, which is the number of channels of the plane `lit`
void resize(
    Film& film, int width, int height, bool color, std::span<const Aov> aovs, std::size_t lights);

/// Sets the size of all other planes to zero.
void clear_unused(Film& film, bool color, std::span<const Aov> aovs);

} // namespace firsthit
