// picture_codes.h - a picture's colours as 8-bit sRGB, row by row.
#pragma once

#include "film/picture_files.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace firsthit {

/// The code whose light is the nearest below or at a linear value, and how far the value is towards the next
/// code's light, 0 to less than 1. Values are clamped to [0, 1]; NaN counts as 0.
struct DitherCode {
    std::uint8_t code;
    float fraction;
};
DitherCode dither_code(float linear);

/// The value, above 0 and below 1, above which a fraction is rounded up at a pixel: an ordered 8 x 8 matrix.
/// source  Bayer 1973, "An optimum method for two-level rendition of continuous-tone pictures"
float dither_threshold(int x, int y);

/// Rows of RGB, or of RGBA where there is an alpha. Views what it was made of.
class PictureCodes {
  public:
    /// color   (height, width, 3), linear; straight where there is an alpha
    /// alpha   (height, width), 0 to 1, or empty
    /// origin  where its first pixel is in the whole picture, which the pattern of dithering goes by
    PictureCodes(const PlaneView& color, std::span<const float> alpha, bool dither,
        const glm::ivec2& origin = {0, 0})
        : color_(color),
          alpha_(alpha),
          dither_(dither),
          origin_(origin)
    {
    }

    int width() const { return color_.width; }
    int height() const { return color_.height; }
    int channels() const { return alpha_.empty() ? 3 : 4; }

    /// Fills in row y, width * channels values.
    void row(int y, std::span<std::uint8_t> codes) const;

  private:
    PlaneView color_;
    std::span<const float> alpha_;
    bool dither_;
    glm::ivec2 origin_;
};

} // namespace firsthit
