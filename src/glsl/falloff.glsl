// falloff.glsl - how a light of a point in space fades with distance.

/// The inverse square of the distance, times a window that ends at the light's range.
///
/// inv_range2  one over the square of the range; 0: no window
///
/// source  Khronos 2020, KHR_lights_punctual ("Range Property")
FIRSTHIT_PURE real inverse_square(real distance2, real inv_range2)
{
    real share = distance2 * inv_range2;
    real window = max(1.0f - share * share, 0.0f);
    return window / max(distance2, 1.0e-12f);
}
