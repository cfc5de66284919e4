// item.vert - transforms a corner from eye space to clip space: see gl/items/item_pass.h.
#include "gl/bindings.glsl"

layout(location = kEyeAttribute) in vec3 eye;

uniform vec2 scale; // clip = scale * (x, y) / z + shift, see SampleToClip
uniform vec2 shift;
uniform vec2 depth; // depth value = depth.x / z + depth.y

void main()
{
    gl_Position = vec4(eye.xy * scale + eye.z * shift, depth.x + depth.y * eye.z, eye.z);
}
