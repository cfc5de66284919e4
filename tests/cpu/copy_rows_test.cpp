// copy_rows_test.cpp - copies a tile's planes to rows of pixels, past the caches or not.
#include "cpu/copy_rows.h"

#include "base/tile_order.h"
#include "instruction_sets.h"

#include <gtest/gtest.h>

#include <vector>

namespace firsthit {
namespace {

TEST(CopyRows, CopiesPixelByPixelForEveryWidthAndAlignment)
{
    constexpr int kTile = 24, kFilmWidth = 61, kFilmHeight = 30;
    alignas(64) static float plane[3][kTile * kTile];
    for (int k = 0; k < kTile * kTile; ++k)
        for (int c = 0; c < 3; ++c) plane[c][k] = float(10 * k + c);
    const float* const from[] = {plane[0], plane[1], plane[2]};

    for_instruction_sets([&] {
        for (std::size_t channels = 1; channels <= 3; ++channels)
            for (const bool stream : {false, true})
                for (int width = 1; width <= kTile; ++width) {
                    // The first pixel and the film have all alignments to cache lines.
                    const PixelRect rect{width + 7, 3, width, 20};
                    std::vector<float> film(3 * kFilmWidth * kFilmHeight + 16, -1.0f);
                    std::vector<float> expected = film;
                    float* const to = film.data() + width % 16;
                    copy_rows(rect, kTile, {from, channels}, {to, kFilmWidth, stream});
                    for (int y = 0; y < rect.height; ++y)
                        for (int x = 0; x < width; ++x)
                            for (std::size_t c = 0; c < channels; ++c)
                                expected[std::size_t(width % 16) +
                                         std::size_t(
                                             (rect.film_y + y) * kFilmWidth + rect.film_x + x) *
                                             channels +
                                         c] = plane[c][tile_offset(x, y, kTile)];
                    ASSERT_EQ(film, expected) << channels << " " << stream << " " << width;
                }
    });
}

TEST(FillRows, FillsExactlyThePixelsOfTheRectangle)
{
    constexpr int kFilmWidth = 61, kFilmHeight = 30;
    const glm::vec3 color(0.25f, 0.5f, 2.0f);
    for_instruction_sets([&] {
        for (const bool stream : {false, true})
            for (int width = 1; width <= 40; ++width) {
                const PixelRect rect{width % 20, 3, width, 20};
                std::vector<float> film(3 * kFilmWidth * kFilmHeight + 16, -1.0f);
                std::vector<float> expected = film;
                fill_rows(rect, color, {film.data() + width % 16, kFilmWidth, stream});
                for (int y = 0; y < rect.height; ++y)
                    for (int k = 0; k < 3 * width; ++k)
                        expected[std::size_t(
                            width % 16 + k + 3 * ((rect.film_y + y) * kFilmWidth + rect.film_x))] =
                            color[k % 3];
                ASSERT_EQ(film, expected) << stream << " " << width;
            }
    });
}

} // namespace
} // namespace firsthit
