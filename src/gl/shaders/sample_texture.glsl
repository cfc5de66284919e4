// sample_texture.glsl - the texture's colour at a sample, trilinear: src/shade/sample_texture-inl.h.
//
// All texels of all textures lie in one buffer (gl/scene/material_buffers.h): any number of textures of any
// size, and the texels' weights are the text's own, not a texture unit's 8 bits.

layout(binding = 12) uniform usamplerBuffer texture_words;

uint texture_word(uint at)
{
    return texelFetch(texture_words, int(at)).x;
}

/// Of level 0, texels.
vec2 texture_size(int texture_id)
{
    uint row = 4u * uint(texture_id);
    return vec2(texture_word(row + 2u), texture_word(row + 3u));
}

/// Red, green and blue, 0 to -32768.
ivec3 fetch_texel(uint at)
{
    int red_green = int(texture_word(at));
    int blue_alpha = int(texture_word(at + 1u));
    return ivec3(red_green << 16, red_green, blue_alpha << 16) >> 16;
}

/// The sum of the weighted texels of a level.
ivec3 sample_level(uint first, vec2 at, vec2 size, int weight)
{
    Texels texels = bilinear_texels(at.x, at.y, size.x, size.y);
    TexelWeights weights = texel_weights(texels, weight);
    uint top = first + 2u * uint(texels.top);
    uint bottom = first + 2u * uint(texels.bottom);
    return weights.top_left * fetch_texel(top) + weights.top_right * fetch_texel(top + 2u) +
           weights.bottom_left * fetch_texel(bottom) +
           weights.bottom_right * fetch_texel(bottom + 2u);
}

/// source  Williams 1983, "Pyramidal parametrics"
vec3 sample_texture(int texture_id, vec2 uv, float length2)
{
    uint row = 4u * uint(texture_id);
    uint levels = texture_word(row);
    vec2 size = texture_size(texture_id);
    vec2 at = vec2(repeat(uv.x), 1.0 - repeat(uv.y));
    float level = mip_level(length2, float(texture_word(row + 1u) - 1u));
    float finer = floor(level);
    int coarse = whole_to_integer((level - finer) * 32767.0);

    ivec3 sum = sample_level(texture_word(levels + uint(finer)), at,
        vec2(level_size(size.x, finer), level_size(size.y, finer)), whole_weight() - coarse);
    if (coarse > 0)
        sum += sample_level(texture_word(levels + uint(finer) + 1u), at,
            vec2(level_size(size.x, finer + 1.0), level_size(size.y, finer + 1.0)), coarse);
    return vec3(texel_light(sum.x), texel_light(sum.y), texel_light(sum.z));
}
