// shadow_depth.frag - nothing but depth.

void main() {}
