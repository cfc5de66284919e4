// lay_over.cpp - what stands behind a picture with transparency.
#include "film/endings.h"

#include <firsthit/error.h>
#include <firsthit/picture.h>

#include <fmt/format.h>
#include <glm/common.hpp>

#include <cmath>

namespace firsthit {
namespace {

void check_backdrop(const glm::vec3& color)
{
    for (int c = 0; c < 3; ++c)
        if (!(color[c] >= 0) || std::isinf(color[c]))
            throw ArgumentError(
                fmt::format("({:g}, {:g}, {:g}) is no colour of a background: accepted are "
                            "finite numbers of at least 0",
                    color.x, color.y, color.z));
}

} // namespace

void lay_over(Film& film, const Gradient& gradient, int first_row, int rows)
{
    check_backdrop(gradient.top);
    check_backdrop(gradient.bottom);
    check_shape(film, {film.width, film.height, 3, film.color.value}, "color");
    check_shape(film, {film.width, film.height, 1, film.alpha.value}, "alpha");
    std::size_t pixel = 0;
    for (int y = 0; y < film.height; ++y) {
        const float down = (float(first_row + y) + 0.5f) / float(rows);
        const glm::vec3 behind = glm::mix(gradient.top, gradient.bottom, down);
        for (int x = 0; x < film.width; ++x, ++pixel) {
            const float seen = 1 - film.alpha.value[pixel];
            for (int c = 0; c < 3; ++c)
                film.color.value[3 * pixel + std::size_t(c)] += seen * behind[c];
        }
    }
    film.alpha.value.clear();
}

} // namespace firsthit
