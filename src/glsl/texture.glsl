// texture.glsl - texture sampling: footprint, mip level, repetition, bilinear weights.

/// Linear interpolation: a for amount = 0, b for amount = 1. Exactly a if a = b.
FIRSTHIT_PURE real blend(real a, real b, real amount)
{
    return a + (b - a) * amount;
}
FIRSTHIT_PURE real3 blend3(real3 a, real3 b, real amount)
{
    return a + (b - a) * amount;
}

/// The square of the longer side of a sample's footprint on the texture, in texels of level 0.
///
/// Let the ray of sample (x, y) be d = (X, Y, 1) with X = x / f, and let w1, w2 be the barycentric
/// weights of corners 1 and 2 where it hits the triangle, at depth t. The hit is t d = p0 + w1 e1 +
/// w2 e2, where p0 is the first corner relative to the eye. By Cramer's rule, with N = e1 x e2,
///     1 / t  = (N / N.p0) . d        w1 / t = (e2 x p0 / N.p0) . d       w2 / t = (p0 x e1 / N.p0)
///     . d
/// are affine in (X, Y). So is r / t for r = w1 r1 + w2 r2, where r is a texture coordinate and r,
/// r1, r2 are relative to its value at corner 0. By the quotient rule
///     dr/dx = t (d(r / t)/dx - r d(1 / t)/dx)
/// and the gradients on the right are the same for the whole triangle.
///
/// u, v           texture coordinates relative to corner 0
/// grad_u, _v, _1 d/dx and d/dy of u / t, v / t, 1 / t for one step to the next sample
/// size           width and height of level 0, texels
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

/// How much a texture coordinate changes to the next sample along x or y: dr/dx of footprint2.
FIRSTHIT_PURE real texture_step(real r, real t, real grad_r, real grad_1)
{
    return t * (grad_r - r * grad_1);
}

/// footprint2 of a texture that is sampled at per_u * u + per_v * v + an offset.
///
/// step_u, _v  how much u and v change to the next sample along x and along y
FIRSTHIT_PURE real moved_footprint2(
    real2 step_u, real2 step_v, real2 per_u, real2 per_v, real2 size)
{
    real u_x = size.x * (per_u.x * step_u.x + per_v.x * step_v.x);
    real u_y = size.x * (per_u.x * step_u.y + per_v.x * step_v.y);
    real v_x = size.y * (per_u.y * step_u.x + per_v.y * step_v.x);
    real v_y = size.y * (per_u.y * step_u.y + per_v.y * step_v.y);
    return max(u_x * u_x + v_x * v_x, u_y * u_y + v_y * v_y);
}

/// The fractional mip level, in [0, last], on which the footprint is about one texel wide.
FIRSTHIT_PURE real mip_level(real length2, real last)
{
    return min(max(0.5f * steady_log2(length2), 0.0f), last);
}

/// Repeats the texture: the fractional part of s, in [0, 1] (rounding may give 1). 0 for NaN and
/// infinity.
FIRSTHIT_PURE real repeat(real s)
{
    real rest = s - floor(s);
    return mix(real(0.0f), rest, rest > real(0.0f));
}

/// The position of coordinate s in the texture, 0 to 1.
///
/// wrap  0 repeats the texture, 1 mirrors it, 2 continues its edge: the numbers of Wrap
FIRSTHIT_PURE real wrapped(real s, int wrap)
{
    if (wrap == 0) return repeat(s);
    if (wrap == 2) return min(max(s, 0.0f), 1.0f);
    real there_and_back = 2.0f * repeat(0.5f * s);
    return min(there_and_back, 2.0f - there_and_back);
}

/// The width or height of a mip level, in texels, if level 0 has `size` texels. All are whole
/// numbers.
FIRSTHIT_PURE real level_size(real size, real level)
{
    real share = intBitsToFloat(shift_left_23(integer(127) - whole_to_integer(level))); // 2^-level
    return max(floor(size * share), 1.0f);
}

/// The four texels of a bilinear lookup. Around each level there is a border of one texel that
/// continues it as the sampler's wrap modes say.
struct Texels {
    integer top;       // index of the top left texel, counted from the border's corner; the right is next
    integer bottom;    // index of the bottom left texel
    integer to_right;  // 0 to 32768: position of the sample between the left and the right texels
    integer to_bottom; // 0 to 32768: the same between the top and the bottom texels
};

/// right          position of the sample, from 0 at the texture's left edge to 1 at its right edge
/// down           the same from the top to the bottom edge
/// width, height  of the level without its border, whole numbers of at most 2^14
FIRSTHIT_PURE Texels bilinear_texels(real right, real down, real width, real height)
{
    // Texel centres are at whole numbers, the first border texel at 0. x is in [0.5, width + 0.5].
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

/// The texel that contains the sample, as the top left of four of which the others have no weight.
/// The arguments are those of bilinear_texels.
FIRSTHIT_PURE Texels nearest_texels(real right, real down, real width, real height)
{
    real x = floor(min(right * width, width - 0.5f)) + 1.0f;
    real y = floor(min(down * height, height - 0.5f)) + 1.0f;
    integer row = whole_to_integer(width + 2.0f);

    Texels texels;
    texels.top = whole_to_integer(y) * row + whole_to_integer(x);
    texels.bottom = texels.top + row;
    texels.to_right = integer(0);
    texels.to_bottom = integer(0);
    return texels;
}

/// The sum of the weights of all texels of a sample. Weights and texels are integers, so that sums
/// of their products do not depend on the order, and rounding the weights does not change their
/// sum.
FIRSTHIT_PURE integer whole_weight()
{
    return integer(32767);
}

/// The weights of four texels. None is negative, and their sum is exact.
struct TexelWeights {
    integer top_left, top_right, bottom_left, bottom_right;
};

/// all * fraction / 32768, rounded.
FIRSTHIT_PURE integer share_of(integer all, integer fraction)
{
    return shift_right_15(all * fraction + 16384);
}

/// all  sum of the four weights
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

/// Converts a sum of weighted texels to linear light. A texel of -32768 stands for 1.
FIRSTHIT_PURE real texel_light(integer sum)
{
    return real(sum) * (-1.0f / (32768.0f * 32767.0f));
}
