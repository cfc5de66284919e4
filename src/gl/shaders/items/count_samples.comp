// count_samples.comp - counts the samples that were hit, missed and interpolated. Each invocation
// handles a block of 8 x 8 samples.
#include "frame.glsl"
#include "find_hit.glsl"

layout(local_size_x = 32) in;

layout(binding = kColorsUnit) uniform sampler2D colors; // for their alpha: see shade_hits.frag
layout(std430, binding = kResultBlock) buffer Counts { uint counts[3]; }; // hits, missed, interpolated

ivec2 size()
{
#if FIRSTHIT_COUNT_HITS
    return frame.size;
#else
    return textureSize(colors, 0);
#endif
}

/// 1 in the component (hits, missed, interpolated) that the sample counts for.
uvec3 count_of(ivec2 at)
{
#if FIRSTHIT_COUNT_HITS
    uint item = find_hit(at).item;
    return uvec3(item < kHole ? 1u : 0u, item == kHole && is_shot(at) ? 1u : 0u, 0u);
#else
    float alpha = texelFetch(colors, at, 0).a;
    return uvec3(alpha == kHitAlpha ? 1u : 0u, alpha <= kFilledAlpha && is_shot(at) ? 1u : 0u,
        alpha == kFilledAlpha ? 1u : 0u);
#endif
}

void main()
{
    ivec2 blocks = (size() + 7) / 8;
    int number = int(gl_GlobalInvocationID.x);
    if (number >= blocks.x * blocks.y) return;
    ivec2 first = 8 * ivec2(number % blocks.x, number / blocks.x);
    uvec3 sum = uvec3(0u);
    for (int k = 0; k < 64; ++k) {
        ivec2 at = first + ivec2(k & 7, k >> 3);
        if (all(lessThan(at, size()))) sum += count_of(at);
    }
    for (int k = 0; k < 3; ++k)
        if (sum[k] != 0u) atomicAdd(counts[k], sum[k]);
}
