// average.frag - the colour of a pixel: the mean of those of its N x N samples that are not holes.
#include "frame.glsl"

layout(binding = kColorsUnit) uniform sampler2D colors;
layout(location = kAverageSamples) uniform int samples; // N
layout(location = 0) out vec4 color_out;

void main()
{
    ivec2 first = ivec2(gl_FragCoord.xy) * samples;
    vec4 sum = vec4(0.0);
    for (int y = 0; y < samples; ++y)
        for (int x = 0; x < samples; ++x) {
            vec4 color = texelFetch(colors, first + ivec2(x, y), 0);
            if (color.a != kHoleAlpha) sum += vec4(color.rgb, 1.0);
        }
    color_out = sum.a > 0.0 ? vec4(sum.rgb / sum.a, kHitAlpha)
                            : vec4(texelFetch(colors, first, 0).rgb, kHoleAlpha);
}
