// scatter.frag - writes the given item of a sample: see gl/items/certified_gpu_items.h.

flat in uint given;
layout(location = 0) out uint item;

void main()
{
    item = given;
}
