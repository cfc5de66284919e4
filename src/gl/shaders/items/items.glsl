// items.glsl - the item buffer: which triangle does a sample see? See gl/items/item_pass.h.
// kNoItem, no triangle, is that of firsthit/scene.h: gl/device/program.cpp defines it for all shaders.

// FIRSTHIT_ITEM_CHANNELS 1: items are integers. 3 or 4: items are colours as in the paper, with the
// lowest byte in red.
#if FIRSTHIT_ITEM_CHANNELS == 1
layout(binding = kItemsUnit) uniform usampler2D items;
#else
layout(binding = kItemsUnit) uniform sampler2D items;
#endif

uint item_at(ivec2 sample_at)
{
#if FIRSTHIT_ITEM_CHANNELS == 1
    return texelFetch(items, sample_at, 0).x;
#else
    uint bits = packUnorm4x8(texelFetch(items, sample_at, 0));
    // Without an alpha channel, alpha reads as 1, so the background still has all bits set.
    return FIRSTHIT_ITEM_CHANNELS == 4 || bits == kNoItem ? bits : bits & 0xFFFFFFu;
#endif
}
