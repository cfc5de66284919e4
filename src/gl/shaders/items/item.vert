// item.vert - a triangle's corner from eye space to the picture: see gl/items/item_pass.h.

layout(location = 0) in vec3 eye;

uniform vec2 scale; // of eye space, to -1 .. 1 after the division by z
uniform vec2 shift;
uniform vec2 depth; // depth = x / z + y

void main()
{
    gl_Position = vec4(eye.xy * scale + eye.z * shift, depth.x + depth.y * eye.z, eye.z);
}
