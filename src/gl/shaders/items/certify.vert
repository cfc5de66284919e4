// certify.vert - passes a corner in eye space on to certify.geom: see gl/items/certified_items.h.
#include "gl/bindings.glsl"

layout(location = kEyeAttribute) in vec3 eye;

out vec3 corner;

void main()
{
    corner = eye;
    gl_Position = vec4(0);
}
