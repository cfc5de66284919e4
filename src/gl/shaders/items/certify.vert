// certify.vert - hands a triangle's corner on, as it is in eye space: see gl/items/certified_items.h.

layout(location = 0) in vec3 eye;

out vec3 corner;

void main()
{
    corner = eye;
    gl_Position = vec4(0);
}
