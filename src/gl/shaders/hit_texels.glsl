// hit_texels.glsl - a hit as it is kept between passes: RGBA32UI.

uvec4 hit_texel(Hit hit)
{
    return uvec4(hit.item, floatBitsToUint(hit.t), floatBitsToUint(hit.u), floatBitsToUint(hit.v));
}
