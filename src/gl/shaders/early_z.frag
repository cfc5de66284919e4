// early_z.frag - masks the samples that have nothing to shade. Writes depth only for samples whose
// ray may hit an item. The following passes test for this depth before their shaders run.
//
// source  Robert and Schoepke 2006, section 4.2.2
#include "frame.glsl"
#include "items.glsl"


void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    if (!is_shot(at)) discard;
    // If every sample tests the items of its neighbours, one neighbour with an item is enough.
    int reach = FIRSTHIT_TEST == 3 ? frame.reach : 0;
    bool found = false;
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) {
            ivec2 p = clamp(at + ivec2(x, y), ivec2(0), frame.size - 1);
            found = found || item_at(p) != kNoItem;
        }
    if (!found) discard;
}
