// items.glsl - the item buffer: which triangle does a sample see? See gl/item_pass.h.

const uint kNoItem = 0xFFFFFFFFu; // background

layout(binding = 0) uniform usampler2D items;
layout(binding = 1) uniform sampler2D item_colors; // the paper's codings, red the lowest byte

uint item_at(ivec2 sample_at)
{
    if (frame.item_channels == 1) return texelFetch(items, sample_at, 0).x;
    uint bits = packUnorm4x8(texelFetch(item_colors, sample_at, 0));
    // Without alpha, which is then 1, none has all bits as well.
    return frame.item_channels == 4 || bits == kNoItem ? bits : bits & 0xFFFFFFu;
}
