// texture.glsl - which texels a sample sees: footprint, mip level, repeat, bilinear weights.

/// a at 0, b at 1, exactly a where a = b.
FIRSTHIT_PURE real blend(real a, real b, real amount)
{
    return a + (b - a) * amount;
}
FIRSTHIT_PURE real3 blend3(real3 a, real3 b, real amount)
{
    return a + (b - a) * amount;
}

/// The longer side of a sample's footprint on the texture, squared, in texels of level 0.
///
/// Let the ray of sample (x, y) be d = (X, Y, 1) with X = x / f, and let w1, w2 be the weights of
/// corners 1 and 2 where it meets the triangle, at depth t. The point is t d = p0 + w1 e1 + w2 e2,
/// with p0 the first corner seen from the eye, so by Cramer's rule, with N = e1 x e2,
///     1 / t  = (N / N.p0) . d        w1 / t = (e2 x p0 / N.p0) . d       w2 / t = (p0 x e1 / N.p0) . d
/// are affine in (X, Y), and so is r / t for r = w1 r1 + w2 r2: a texture coordinate, less its value
/// at corner 0 (r1 and r2 too). By the quotient rule
///     dr/dx = t (d(r / t)/dx - r d(1 / t)/dx)
/// where the gradients on the right are the same for the whole triangle.
///
/// u, v           texture coordinates, less corner 0's
/// grad_u, _v, _1 d/dx and d/dy of u / t, v / t, 1 / t for one step to the next sample
/// size           of level 0, texels
FIRSTHIT_PURE real footprint2(
    real u, real v, real t, real2 grad_u, real2 grad_v, real2 grad_1, real2 size)
{
    real t_width = t * size.x;
    real t_height = t * size.y;
    real u_x = t_width * (grad_u.x - u * grad_1.x);
    real u_y = t_width * (grad_u.y - u * grad_1.y);
    real v_x = t_height * (grad_v.x - v * grad_1.x);
    real v_y = t_height * (grad_v.y - v * grad_1.y);
    return max(u_x * u_x + v_x * v_x, u_y * u_y + v_y * v_y);
}

/// The mip level of a footprint, fractional, in [0, last]: one sample is about one texel there.
FIRSTHIT_PURE real mip_level(real length2, real last)
{
    return min(max(0.5f * steady_log2(length2), 0.0f), last);
}

/// The fraction of s, in [0, 1]: repeats the texture. 0 for what is no number, or infinite.
FIRSTHIT_PURE real repeat(real s)
{
    real rest = s - floor(s);
    return mix(real(0.0f), rest, rest > real(0.0f));
}

/// Four texels and their weights, in a level `width` wide.
struct Texels {
    integer top_left, top_right, bottom_left, bottom_right; // index in the level, row by row
    real right;  // weight of the right two, in [0, 1]
    real bottom; // weight of the bottom two
};

/// u to the right, v up: (0, 0) is the bottom left corner of the picture, whose rows go down.
/// width, height  at most 2^22, and the texels at most 2^31 - 1
FIRSTHIT_PURE Texels bilinear_texels(real u, real v, real width, real height)
{
    // Texel centres are at +0.5. x and y are in [-0.5, size - 0.5].
    real x = repeat(u) * width - 0.5f;
    real y = (1.0f - repeat(v)) * height - 0.5f;
    real x0 = floor(x);
    real y0 = floor(y);
    real x1 = x0 + 1.0f;
    real y1 = y0 + 1.0f;

    integer left = whole_to_integer(mix(x0 + width, x0, x0 >= real(0.0f)));
    integer right = whole_to_integer(mix(real(0.0f), x1, x1 < width));
    integer row = whole_to_integer(width);
    integer top = whole_to_integer(mix(y0 + height, y0, y0 >= real(0.0f))) * row;
    integer bottom = whole_to_integer(mix(real(0.0f), y1, y1 < height)) * row;

    Texels texels;
    texels.top_left = top + left;
    texels.top_right = top + right;
    texels.bottom_left = bottom + left;
    texels.bottom_right = bottom + right;
    texels.right = x - x0;
    texels.bottom = y - y0;
    return texels;
}
