// phong_exponent.h - which power function a material's shininess asks for.
#pragma once

namespace firsthit {

/// The arguments of `highlight` in src/glsl/phong.glsl.
struct PhongExponent {
    int whole = -1; // the exponent, if it is whole and at most 64; else -1
    float value = 0;
};

/// Squaring is faster and, to 64, as exact as steady_pow: each product adds at most 6e-8.
/// A negative exponent, or one that is no number, counts as 0.
inline PhongExponent phong_exponent(float shininess)
{
    if (!(shininess > 0.0f)) return {.whole = 0};
    if (shininess <= 64.0f) {
        const int whole = static_cast<int>(shininess);
        if (static_cast<float>(whole) == shininess) return {.whole = whole, .value = shininess};
    }
    return {.whole = -1, .value = shininess};
}

} // namespace firsthit
