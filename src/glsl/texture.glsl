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

/// How wide or high a level is, of a texture that is `size` wide or high; both whole.
FIRSTHIT_PURE real level_size(real size, real level)
{
    real share = intBitsToFloat(shift_left_23(integer(127) - whole_to_integer(level))); // 2^-level
    return max(floor(size * share), 1.0f);
}

/// Four texels of a level that has a border of one texel around it, where it begins anew.
struct Texels {
    integer top;    // index of the top left one, from the border's corner on; the right one is next
    integer bottom; // index of the bottom left one
    integer to_right;  // 0 to 32768: how far the sample is from the left two to the right two
    integer to_bottom; // 0 to 32768
};

/// right         how far the sample is from the picture's left edge to its right one, 0 to 1
/// down          from the top to the bottom edge
/// width, height of the level without its border, at most 2^14; whole
FIRSTHIT_PURE Texels bilinear_texels(real right, real down, real width, real height)
{
    // Texel centres are at whole numbers, the border's at 0. x is in [0.5, width + 0.5].
    real x = right * width + 0.5f;
    real y = down * height + 0.5f;
    real x0 = floor(x);
    real y0 = floor(y);
    integer row = whole_to_integer(width + 2.0f);

    Texels texels;
    texels.top = whole_to_integer(y0) * row + whole_to_integer(x0);
    texels.bottom = texels.top + row;
    texels.to_right = whole_to_integer((x - x0) * 32768.0f);
    texels.to_bottom = whole_to_integer((y - y0) * 32768.0f);
    return texels;
}

/// What the weights of all texels of a sample sum up to. Weights are whole, so that sums of products
/// with whole texels are the same in any order, and no weight is lost where they are rounded.
FIRSTHIT_PURE integer whole_weight()
{
    return integer(32767);
}

/// The weights of four texels. Their sum is that of all four, none is negative.
struct TexelWeights {
    integer top_left, top_right, bottom_left, bottom_right;
};

/// part of 32768, rounded
FIRSTHIT_PURE integer share_of(integer all, integer part)
{
    return shift_right_15(all * part + 16384);
}

FIRSTHIT_PURE TexelWeights texel_weights(Texels texels, integer all)
{
    integer bottom = share_of(all, texels.to_bottom);
    integer top = all - bottom;
    TexelWeights weights;
    weights.top_right = share_of(top, texels.to_right);
    weights.top_left = top - weights.top_right;
    weights.bottom_right = share_of(bottom, texels.to_right);
    weights.bottom_left = bottom - weights.bottom_right;
    return weights;
}

/// The colour from the sum of weighted texels, which are -32768 where it is 1.
FIRSTHIT_PURE real texel_light(integer sum)
{
    return real(sum) * (-1.0f / (32768.0f * 32767.0f));
}
