// picture_difference.cpp - how many pixels of two pictures are not the same.
#include "bench/baseline/picture_difference.h"

#include "bench/report/picture.h"

#include <firsthit/error.h>

#include <cstdlib>

namespace firsthit::cli::bench {

PictureDifference difference(const Film& a, const Film& b)
{
    const Picture shown_a = picture_of(a), shown_b = picture_of(b);
    if (a.width != b.width || a.height != b.height || a.item.size() != b.item.size() ||
        3 * a.item.size() != shown_a.rgb.size())
        throw ArgumentError("pictures of different sizes, or without items, are not compared");
    PictureDifference found{.pixels = a.item.size()};
    for (std::size_t k = 0; k < a.item.size(); ++k) {
        found.items += a.item[k] != b.item[k];
        bool same = true;
        for (std::size_t c = 3 * k; c < 3 * k + 3; ++c)
            same &= std::abs(int(shown_a.rgb[c]) - int(shown_b.rgb[c])) <= 1;
        found.colors += !same;
    }
    return found;
}

Json difference_json(const PictureDifference& difference)
{
    return {
        {"pixels", difference.pixels}, {"items", difference.items}, {"colors", difference.colors}};
}

} // namespace firsthit::cli::bench
