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

void resize(
    Film& film, int width, int height, bool color, std::span<const Aov> aovs, std::size_t lights)
{
    const std::size_t pixels = std::size_t(width) * std::size_t(height);
    const auto size = [&](Plane& plane, int channels) {
        plane.channels = channels;
        resize_in_large_pages(plane.value, pixels * std::size_t(channels));
    };
    if (color) size(film.color, 3);
    for (const Aov aov : aovs) {
        if (aov == Aov::item)
            resize_in_large_pages(film.item, pixels);
        else
            size(film[aov], aov == Aov::lit ? int(lights) : aov_channels(aov));
    }
}

void clear_unused(Film& film, bool color, std::span<const Aov> aovs)
{
    if (!color) film.color.value.clear();
    if (!contains(aovs, Aov::item)) film.item.clear();
    for (int a = 0; a < kAovCount; ++a)
        if (!contains(aovs, Aov(a))) film[Aov(a)].value.clear();
}

} // namespace firsthit
