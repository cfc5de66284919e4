// scatter.frag - writes the sample's item: see gl/items/certified_gpu_items.h.

flat in uint given;
layout(location = 0) out uint item;

void main()
{
    item = given;
}
