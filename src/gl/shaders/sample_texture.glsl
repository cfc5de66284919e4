// sample_texture.glsl - the texture's colour at a sample, trilinear: src/shade/sample_texture-inl.h.
//
// All texels of all textures lie in one buffer (gl/texture_words.h): any number of textures of any
// size, and the texels' weights are the text's own, not a texture unit's 8 bits.

layout(binding = 12) uniform usamplerBuffer texture_words;

const uint kTextureTable = 256u; // before it: linear light of the 256 sRGB codes, floats

uint texture_word(uint at)
{
    return texelFetch(texture_words, int(at)).x;
}

struct TextureLevel {
    uint first; // of its texels
    int width; // 0: cannot be sampled, white
    int height;
};

/// Of the texture's row of the table: where its levels' rows are, how many there are.
uvec2 texture_levels(int texture_id)
{
    uint row = kTextureTable + 2u * uint(texture_id);
    return uvec2(texture_word(row), texture_word(row + 1u));
}

TextureLevel texture_level(uint row)
{
    return TextureLevel(
        texture_word(row), int(texture_word(row + 1u)), int(texture_word(row + 2u)));
}

/// Of level 0, texels.
vec2 texture_size(int texture_id)
{
    TextureLevel level = texture_level(texture_levels(texture_id).x);
    return vec2(level.width, level.height);
}

float linear_light(uint code)
{
    return uintBitsToFloat(texture_word(code & 255u));
}

vec3 texel_color(uint at)
{
    uint rgba = texture_word(at);
    return vec3(linear_light(rgba), linear_light(rgba >> 8), linear_light(rgba >> 16));
}

vec3 sample_level(TextureLevel level, vec2 uv)
{
    if (level.width == 0) return vec3(1.0);
    Texels at = bilinear_texels(uv.x, uv.y, float(level.width), float(level.height));
    vec3 top = blend3(texel_color(level.first + uint(at.top_left)),
        texel_color(level.first + uint(at.top_right)), at.right);
    vec3 bottom = blend3(texel_color(level.first + uint(at.bottom_left)),
        texel_color(level.first + uint(at.bottom_right)), at.right);
    return blend3(top, bottom, at.bottom);
}

/// source  Williams 1983, "Pyramidal parametrics"
vec3 sample_texture(int texture_id, vec2 uv, float length2)
{
    uvec2 levels = texture_levels(texture_id);
    float level = mip_level(length2, float(levels.y - 1u));
    float finer = floor(level);
    float amount = level - finer; // of the coarser level
    uint row = levels.x + 3u * uint(finer);
    vec3 color = sample_level(texture_level(row), uv);
    if (amount > 0.0) color = blend3(color, sample_level(texture_level(row + 3u), uv), amount);
    return color;
}
