// film_size.h - room for the planes of a film.
#pragma once

#include <firsthit/film.h>

#include <cstddef>
#include <span>

namespace firsthit {

/// Gives the planes that are asked for their size. Allocates only where the film grows.
/// lights  of the world: the channels of the plane `lit`
void resize(
    Film& film, int width, int height, bool color, std::span<const Aov> aovs, std::size_t lights);

/// Empties the planes that are not asked for.
void clear_unused(Film& film, bool color, std::span<const Aov> aovs);

} // namespace firsthit
