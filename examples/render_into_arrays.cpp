// render_into_arrays.cpp - colour, depth and ids in arrays of the caller: rows and strides as NumPy has them.
#include <firsthit/firsthit.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

/// Somebody's array (height, width, channels): element (i, j, k) is at data + i * row + j * column + k.
template <class T>
struct Array {
    T* data;
    std::ptrdiff_t row, column; // steps, in elements; negative ones run backwards
    int channels;
};

/// Planes are contiguous, (height, width, channels) with the top row first.
template <class T>
void copy(const std::vector<T>& plane, const firsthit::Film& film, const Array<T>& to)
{
    const T* from = plane.data();
    for (std::ptrdiff_t i = 0; i < film.height; ++i)
        for (std::ptrdiff_t j = 0; j < film.width; ++j, from += to.channels)
            std::copy_n(from, to.channels, to.data + i * to.row + j * to.column);
}

int main()
{
    constexpr int kWidth = 320, kHeight = 200;
    firsthit::World world;
    firsthit::pose(firsthit::load_scene("builtin:robots"), 2.5, world);
    firsthit::View view{.camera = world.camera, .width = kWidth, .height = kHeight, .region = {}};
    firsthit::Settings settings;
    settings.aovs = {firsthit::Aov::item, firsthit::Aov::depth};
    firsthit::Film film;
    firsthit::Renderer().render(world, view, settings, film);

    // Red, green, blue, alpha, from the bottom up, as textures want it; depth in rows of 384; ids as they are.
    std::vector<float> rgba(std::size_t(kHeight) * kWidth * 4, 1);
    std::vector<float> depth(std::size_t(kHeight) * 384, -1);
    std::vector<std::uint32_t> id(std::size_t(kHeight) * kWidth);
    constexpr std::ptrdiff_t kRow = kWidth * 4;
    copy<float>(film.color.value, film, {rgba.data() + (kHeight - 1) * kRow, -kRow, 4, 3});
    copy<float>(film[firsthit::Aov::depth].value, film, {depth.data(), 384, 1, 1});
    copy<std::uint32_t>(film.item, film, {id.data(), kWidth, 1, 1});

    int seen = 0;
    float nearest = INFINITY;
    bool right = rgba[3] == 1 && depth[kWidth] == -1; // what lies between stays
    for (std::size_t i = 0; i < kHeight; ++i)
        for (std::size_t j = 0; j < kWidth; ++j) {
            const bool hit = id[i * kWidth + j] != firsthit::kNoItem;
            seen += hit;
            nearest = std::min(nearest, depth[i * 384 + j]);
            right = right && hit == std::isfinite(depth[i * 384 + j]); // +inf where nothing is seen
        }
    std::printf("%d of %d pixels see a triangle, the nearest %.2f m away\n", seen, kWidth * kHeight,
        double(nearest));
    return right && seen > 0 ? 0 : 1;
}
