// looks.cpp - the pixels of each way of looking.
#include "view/frames/looks.h"

#include <firsthit/film_data.h>
#include <firsthit/scene.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace firsthit::cli::view {
namespace {

using Rgb = std::array<float, 3>;

constexpr Rgb kNothing{0.11f, 0.11f, 0.13f}; // of looks other than colour
constexpr std::array<std::uint8_t, 3> kBorder{255, 150, 20}, kWrong{255, 25, 25};
constexpr float kDifferenceGain = 8; // as texts say

/// sRGB codes of linear values, in steps that are finer than a code.
const std::array<std::uint8_t, 8192>& srgb_codes()
{
    static const auto kCodes = [] {
        std::array<std::uint8_t, 8192> codes{};
        for (std::size_t k = 0; k < codes.size(); ++k) {
            const double v = double(k) / double(codes.size() - 1);
            const double s = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
            codes[k] = static_cast<std::uint8_t>(std::lround(255 * s));
        }
        return codes;
    }();
    return kCodes;
}

std::uint8_t srgb_code(float v)
{
    // Written so that what is no number becomes 0.
    const float clamped = v > 0 ? (v < 1 ? v : 1.0f) : 0.0f;
    return srgb_codes()[std::size_t(clamped * 8191 + 0.5f)];
}

std::uint8_t byte_of(float v)
{
    const float clamped = v > 0 ? (v < 1 ? v : 1.0f) : 0.0f;
    return static_cast<std::uint8_t>(clamped * 255 + 0.5f);
}

std::size_t pixels_of(const Film& film)
{
    return std::size_t(film.width) * std::size_t(film.height);
}

/// Calls color(pixel) for all pixels, and stores what it returns as it is.
template <class Color>
void each_pixel(const Film& film, std::vector<std::uint8_t>& rgba, const Color& color)
{
    for (std::size_t k = 0; k < pixels_of(film); ++k) {
        const Rgb c = color(k);
        for (std::size_t channel = 0; channel < 3; ++channel)
            rgba[4 * k + channel] = byte_of(c[channel]);
    }
}

/// A bright colour for a number, far from those of its neighbours.
Rgb color_of_id(std::uint32_t id)
{
    std::uint32_t h = (id + 1) * 2654435761u;
    h ^= h >> 15;
    h *= 2246822519u;
    h ^= h >> 13;
    const auto part = [&](int shift) {
        return 0.25f + 0.75f * float((h >> shift) & 255u) / 255.0f;
    };
    return {part(0), part(8), part(16)};
}

void paint_ids(const Film& film, Aov aov, std::vector<std::uint8_t>& rgba)
{
    const std::vector<std::uint32_t>& ids = film.ids(aov);
    each_pixel(film, rgba,
        [&](std::size_t k) { return ids[k] == kNoItem ? kNothing : color_of_id(ids[k]); });
}

void paint_depth(const Film& film, std::vector<std::uint8_t>& rgba)
{
    const std::vector<float>& depth = film[Aov::depth].value;
    float near = std::numeric_limits<float>::infinity(), far = 0;
    for (const float z : depth)
        if (std::isfinite(z)) near = std::min(near, z), far = std::max(far, z);
    near = std::max(near, 1e-20f);
    const float range = std::max(std::log(far / near), 1e-6f); // as many steps near as far
    each_pixel(film, rgba, [&](std::size_t k) {
        if (!std::isfinite(depth[k])) return kNothing;
        const float v = 1 - 0.85f * std::log(std::max(depth[k], near) / near) / range;
        return Rgb{v, v, v};
    });
}

void paint_normals(const Film& film, std::vector<std::uint8_t>& rgba)
{
    const std::vector<float>& n = film[Aov::normal].value;
    each_pixel(film, rgba, [&](std::size_t k) {
        if (n[3 * k] == 0 && n[3 * k + 1] == 0 && n[3 * k + 2] == 0) return kNothing;
        return Rgb{n[3 * k] / 2 + 0.5f, n[3 * k + 1] / 2 + 0.5f, n[3 * k + 2] / 2 + 0.5f};
    });
}

void paint_uv(const Film& film, std::vector<std::uint8_t>& rgba)
{
    const std::vector<float>& uv = film[Aov::uv].value;
    const auto wrapped = [](float v) { return v - std::floor(v); };
    each_pixel(film, rgba, [&](std::size_t k) {
        if (film.item[k] == kNoItem) return kNothing;
        return Rgb{wrapped(uv[2 * k]), wrapped(uv[2 * k + 1]), 0.2f};
    });
}

void paint_light(const Film& film, int light, std::vector<std::uint8_t>& rgba)
{
    const Plane& lit = film[Aov::lit];
    const auto channels = std::size_t(lit.channels);
    const std::size_t chosen = std::min(std::size_t(light), channels - 1);
    each_pixel(film, rgba, [&](std::size_t k) {
        if (film.item[k] == kNoItem) return kNothing;
        const float v = 0.06f + 0.94f * lit.value[channels * k + chosen];
        return Rgb{v, v, v * 0.85f};
    });
}

void paint_color(const Film& film, const Painting& painting, std::vector<std::uint8_t>& rgba)
{
    if (painting.exact) {
        const std::vector<std::uint8_t> rgb = srgb_pixels(film, painting.tone, painting.dither);
        for (std::size_t k = 0; k < pixels_of(film); ++k)
            for (std::size_t c = 0; c < 3; ++c) rgba[4 * k + c] = rgb[3 * k + c];
        return;
    }
    if (painting.tone.map != ToneMap::none) {
        const std::vector<float> color = toned(film.color.value, painting.tone);
        for (std::size_t k = 0; k < pixels_of(film); ++k)
            for (std::size_t c = 0; c < 3; ++c) rgba[4 * k + c] = srgb_code(color[3 * k + c]);
        return;
    }
    const auto gain = static_cast<float>(std::exp2(painting.tone.exposure_ev));
    const float* color = film.color.value.data();
    std::uint8_t* out = rgba.data();
    for (std::size_t k = 0; k < pixels_of(film); ++k, color += 3, out += 4) {
        out[0] = srgb_code(color[0] * gain);
        out[1] = srgb_code(color[1] * gain);
        out[2] = srgb_code(color[2] * gain);
    }
}

void paint_difference(const Film& film, const Painting& painting, std::vector<std::uint8_t>& rgba)
{
    const std::vector<std::uint8_t> a = srgb_pixels(film, painting.tone, false);
    const std::vector<std::uint8_t> b = srgb_pixels(*painting.reference, painting.tone, false);
    each_pixel(film, rgba, [&](std::size_t k) {
        Rgb d{};
        for (std::size_t c = 0; c < 3; ++c)
            d[c] = kDifferenceGain * std::abs(float(a[3 * k + c]) - float(b[3 * k + c])) / 255;
        return d;
    });
}

/// Items that are right are dark. A wrong one is three pixels wide, or nobody would see it.
void paint_wrong(const Film& film, const Film& exact, std::vector<std::uint8_t>& rgba)
{
    each_pixel(film, rgba, [&](std::size_t k) {
        const Rgb c = film.item[k] == kNoItem ? kNothing : color_of_id(film.item[k]);
        return Rgb{0.3f * c[0], 0.3f * c[1], 0.3f * c[2]};
    });
    const int w = film.width, h = film.height;
    for (std::size_t k = 0; k < pixels_of(film); ++k) {
        if (film.item[k] == exact.item[k]) continue;
        const int x = int(k % std::size_t(w)), y = int(k / std::size_t(w));
        for (int j = std::max(0, y - 1); j <= std::min(h - 1, y + 1); ++j)
            for (int i = std::max(0, x - 1); i <= std::min(w - 1, x + 1); ++i) {
                const std::size_t at = std::size_t(j) * std::size_t(w) + std::size_t(i);
                std::copy(kWrong.begin(), kWrong.end(), &rgba[4 * at]);
            }
    }
}

/// Marks the pixels along the border of an instance, two on each side.
void paint_border(const Film& film, std::uint32_t instance, std::vector<std::uint8_t>& rgba)
{
    const std::vector<std::uint32_t>& ids = film.instance;
    if (ids.size() != pixels_of(film)) return;
    const int w = film.width, h = film.height;
    const auto is = [&](int x, int y) {
        return ids[std::size_t(y) * std::size_t(w) + std::size_t(x)] == instance;
    };
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            const bool here = is(x, y);
            bool border = false;
            for (const int step : {1, 2}) {
                border |= x >= step && is(x - step, y) != here;
                border |= x + step < w && is(x + step, y) != here;
                border |= y >= step && is(x, y - step) != here;
                border |= y + step < h && is(x, y + step) != here;
            }
            if (!border) continue;
            std::uint8_t* pixel = &rgba[4 * (std::size_t(y) * std::size_t(w) + std::size_t(x))];
            std::copy(kBorder.begin(), kBorder.end(), pixel);
        }
}

void add_plane(Settings& settings, Aov aov)
{
    auto& aovs = settings.aovs;
    if (std::find(aovs.begin(), aovs.end(), aov) == aovs.end()) aovs.push_back(aov);
}

} // namespace

std::string ask_for_planes(Look look, std::size_t lights, Settings& settings)
{
    settings.color = look == Look::color || look == Look::difference;
    if ((look == Look::light || look == Look::light_view) && lights == 0) {
        settings.color = true;
        return "the scene has no lights to look at";
    }
    if (look == Look::light && lights > kMaxLitLights) {
        settings.color = true;
        return fmt::format("the scene has {} lights: accepted are up to {}", lights, kMaxLitLights);
    }
    switch (look) {
    case Look::items:
        add_plane(settings, Aov::item);
        break;
    case Look::instances:
        add_plane(settings, Aov::instance);
        break;
    case Look::materials:
        add_plane(settings, Aov::material);
        break;
    case Look::depth:
    case Look::light_view:
        add_plane(settings, Aov::depth);
        break;
    case Look::wrong:
        add_plane(settings, Aov::item);
        break;
    case Look::normals:
        add_plane(settings, Aov::normal);
        break;
    case Look::uv:
        add_plane(settings, Aov::uv);
        add_plane(settings, Aov::item);
        break;
    case Look::light:
        add_plane(settings, Aov::lit);
        add_plane(settings, Aov::item);
        break;
    case Look::color:
    case Look::difference:
        break;
    }
    if (!settings.color) settings.alpha = false;
    return {};
}

void paint(const Film& film, const Painting& painting, std::vector<std::uint8_t>& rgba)
{
    rgba.resize(4 * pixels_of(film));
    for (std::size_t k = 0; k < pixels_of(film); ++k) rgba[4 * k + 3] = 255;
    switch (film.color.empty()   ? painting.look
            : painting.reference ? Look::difference
                                 : Look::color) {
    case Look::color:
        paint_color(film, painting, rgba);
        break;
    case Look::items:
        paint_ids(film, Aov::item, rgba);
        break;
    case Look::instances:
        paint_ids(film, Aov::instance, rgba);
        break;
    case Look::materials:
        paint_ids(film, Aov::material, rgba);
        break;
    case Look::depth:
    case Look::light_view:
        paint_depth(film, rgba);
        break;
    case Look::normals:
        paint_normals(film, rgba);
        break;
    case Look::uv:
        paint_uv(film, rgba);
        break;
    case Look::light:
        paint_light(film, painting.light, rgba);
        break;
    case Look::difference:
        paint_difference(film, painting, rgba);
        break;
    case Look::wrong:
        paint_wrong(film, *painting.reference, rgba);
        break;
    }
    if (painting.selected >= 0)
        paint_border(film, static_cast<std::uint32_t>(painting.selected), rgba);
}

} // namespace firsthit::cli::view
