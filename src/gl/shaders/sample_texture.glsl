// sample_texture.glsl - samples a texture trilinearly, as src/shade/sample_texture-inl.h.
//
// The texels of all textures are in one buffer (gl/scene/material_buffers.h), so there is no limit
// on the number and size of textures. The weights are computed here, because those of texture units
// have 8 bits.

layout(binding = kTexturesUnit) uniform usamplerBuffer texture_words;

uint texture_word(uint at)
{
    return texelFetch(texture_words, int(at)).x;
}

/// Width and height of level 0, texels.
vec2 texture_size(int texture_id)
{
    uint row = 4u * uint(texture_id);
    return vec2(texture_word(row + 2u), texture_word(row + 3u));
}

/// Red, green, blue and alpha of a texel, 0 to -32768.
/// at  index of its first word
ivec4 fetch_texel(uint at)
{
    int red_green = int(texture_word(at));
    int blue_alpha = int(texture_word(at + 1u));
    return ivec4(red_green << 16, red_green, blue_alpha << 16, blue_alpha) >> 16;
}

/// The weighted sum of four texels of a level. `weight` is the sum of their weights.
ivec4 sample_level(uint first, vec2 at, vec2 size, bool nearest, int weight)
{
    Texels texels = nearest ? nearest_texels(at.x, at.y, size.x, size.y)
                            : bilinear_texels(at.x, at.y, size.x, size.y);
    TexelWeights weights = texel_weights(texels, weight);
    uint top = first + 2u * uint(texels.top);
    uint bottom = first + 2u * uint(texels.bottom);
    return weights.top_left * fetch_texel(top) + weights.top_right * fetch_texel(top + 2u) +
           weights.bottom_left * fetch_texel(bottom) +
           weights.bottom_right * fetch_texel(bottom + 2u);
}

/// source  Williams 1983, "Pyramidal parametrics"
vec4 sample_texture(int texture_id, vec2 uv, float length2)
{
    uint row = 4u * uint(texture_id);
    uint levels = texture_word(row);
    uint sampler_word = texture_word(row + 1u);
    bool nearest = (sampler_word >> 16) != 0u;
    vec2 size = texture_size(texture_id);
    vec2 at = vec2(wrapped(uv.x, int(sampler_word >> 8 & 15u)),
        1.0 - wrapped(uv.y, int(sampler_word >> 12 & 15u)));
    float level = mip_level(length2, nearest ? 0.0 : float((sampler_word & 255u) - 1u));
    float finer = floor(level);
    int coarse = whole_to_integer((level - finer) * 32767.0);

    ivec4 sum = sample_level(texture_word(levels + uint(finer)), at,
        vec2(level_size(size.x, finer), level_size(size.y, finer)), nearest, whole_weight() - coarse);
    if (coarse > 0)
        sum += sample_level(texture_word(levels + uint(finer) + 1u), at,
            vec2(level_size(size.x, finer + 1.0), level_size(size.y, finer + 1.0)), nearest, coarse);
    return vec4(texel_light(sum.x), texel_light(sum.y), texel_light(sum.z), texel_light(sum.w));
}
