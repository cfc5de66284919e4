// hit_texels.glsl - packs a hit into a texel of format RGBA32UI, which is kept between passes.

uvec4 hit_texel(Hit hit)
{
    return uvec4(hit.item, floatBitsToUint(hit.t), floatBitsToUint(hit.u), floatBitsToUint(hit.v));
}
