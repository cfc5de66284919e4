// film_size.cpp - sets the sizes of a film's planes.
#include "film/film_size.h"

#include "base/large_pages.h"

#include <algorithm>

namespace firsthit {
namespace {

bool contains(std::span<const Aov> aovs, Aov wanted)
{
    return std::find(aovs.begin(), aovs.end(), wanted) != aovs.end();
}

} // namespace

void resize(Film& film, const Region& region, const FilmPlanes& planes)
{
    film.width = region.width;
    film.height = region.height;
    const std::size_t pixels = std::size_t(region.width) * std::size_t(region.height);
    const auto size = [&](Plane& plane, int channels) {
        plane.channels = channels;
        resize_in_large_pages(plane.value, pixels * std::size_t(channels));
    };
    if (planes.color)
        size(film.color, 3);
    else
        film.color.value.clear();
    for (int a = 0; a < kAovCount; ++a) {
        if (contains(planes.aovs, Aov(a))) continue;
        if (holds_ids(Aov(a)))
            film.ids(Aov(a)).clear();
        else
            film[Aov(a)].value.clear();
    }
    for (const Aov aov : planes.aovs) {
        if (holds_ids(aov))
            resize_in_large_pages(film.ids(aov), pixels);
        else
            size(film[aov], aov == Aov::lit ? int(planes.lights) : aov_channels(aov));
    }
}

} // namespace firsthit
