// shadow_depth.frag - writes no colour, only depth.

void main() {}
