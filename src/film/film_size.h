// film_size.h - sets the sizes of a film's planes.
#pragma once

#include <firsthit/film.h>
#include <firsthit/view.h>

#include <cstddef>
#include <span>

namespace firsthit {

/// What a film is to hold.
struct FilmPlanes {
    bool color = true;
    std::span<const Aov> aovs;
    std::size_t lights = 0; // of the world: the channels of the plane `lit`
};

/// Gives the film the region's size, and the planes that are asked for theirs; empties the others.
/// Allocates only where the film grows.
void resize(Film& film, const Region& region, const FilmPlanes& planes);

} // namespace firsthit
