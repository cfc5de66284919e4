// film_size.h - sets the sizes of a film's planes.
#pragma once

#include <firsthit/film.h>
#include <firsthit/view.h>

#include <cstddef>
#include <span>

namespace firsthit {

/// The planes that a film is to have.
struct FilmPlanes {
    bool color = true;
    std::span<const Aov> aovs;
    std::size_t lights = 0; // number of lights of the world: the channels of the plane `lit`
};

/// Gives the film and the wanted planes the region's size, and empties the other planes. Allocates
/// only if the film grows.
void resize(Film& film, const Region& region, const FilmPlanes& planes);

} // namespace firsthit
