// fill_holes.frag - gives holes the mean of the colours around them, as src/film/fill_holes.h.
// Holes are samples whose triangle was not found or whose ray was not shot.
//
// source  Robert and Schoepke 2006, section 4.1
#include "frame.glsl"

layout(binding = kColorsUnit) uniform sampler2D colors;
layout(location = 0) out vec4 color_out;

const int kReach = 16;

/// The sum, weighted by 1 / distance^2, of the samples that are not holes in the smallest window
/// around the hole that has such samples. Alpha is the sum of the weights; 0 if there are none.
vec4 color_around(ivec2 at)
{
    vec4 sum = vec4(0.0);
    for (int reach = 1; reach <= kReach && sum.a == 0.0; ++reach)
        for (int y = -reach; y <= reach; ++y) {
            // In the inner rows of the window only the ends are new.
            int step = abs(y) == reach ? 1 : 2 * reach;
            for (int x = -reach; x <= reach; x += step) {
                ivec2 p = at + ivec2(x, y);
                if (any(lessThan(p, ivec2(0)))) continue;
                if (any(greaterThanEqual(p, textureSize(colors, 0)))) continue;
                if (!is_shot(p)) continue;
                vec4 color = texelFetch(colors, p, 0);
                if (color.a != kHoleAlpha) sum += vec4(color.rgb, 1.0) / float(x * x + y * y);
            }
        }
    return sum;
}

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    color_out = texelFetch(colors, at, 0);
    if (color_out.a != kHoleAlpha && is_shot(at)) return;
    vec4 sum = color_around(at);
    color_out = sum.a > 0.0 ? vec4(sum.rgb / sum.a, kFilledAlpha) : vec4(color_out.rgb, kHoleAlpha);
}
