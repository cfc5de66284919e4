// items.glsl - the item buffer: which triangle does a sample see? See gl/items/item_pass.h.

const uint kNoItem = 0xFFFFFFFFu; // background

// FIRSTHIT_ITEM_CHANNELS: 1: integers; 3, 4: the paper's colours, red the lowest byte.
#if FIRSTHIT_ITEM_CHANNELS == 1
layout(binding = 0) uniform usampler2D items;
#else
layout(binding = 0) uniform sampler2D items;
#endif

uint item_at(ivec2 sample_at)
{
#if FIRSTHIT_ITEM_CHANNELS == 1
    return texelFetch(items, sample_at, 0).x;
#else
    uint bits = packUnorm4x8(texelFetch(items, sample_at, 0));
    // Without alpha, which is then 1, none has all bits as well.
    return FIRSTHIT_ITEM_CHANNELS == 4 || bits == kNoItem ? bits : bits & 0xFFFFFFu;
#endif
}
