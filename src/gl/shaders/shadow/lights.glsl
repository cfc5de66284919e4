// lights.glsl - the lights and their shadow maps.
#include "gl/layouts.glsl"

// FIRSTHIT_FEW_LIGHTS is the size of the uniform block, which is faster, or 0: then the lights are
// in a storage block.
#if FIRSTHIT_FEW_LIGHTS
layout(std140, binding = kLightsBlock) uniform Lights { LightData light_data[FIRSTHIT_FEW_LIGHTS]; };
#else
layout(std430, binding = kLightsBlock) readonly buffer Lights { LightData light_data[]; };
#endif

/// The point at depth t of the ray with eye-space direction (X, Y, 1), in the space that `to` leads
/// to.
vec3 transform_ray(Rays to, vec3 eye_d, float t)
{
    return to.eye + t * ((eye_d.x * to.right + eye_d.y * to.down) + to.forward);
}

/// The face that a point lies on. p is in the axes of the light.
int face_of(vec3 p)
{
    vec3 size = abs(p);
    if (size.z >= size.x && size.z >= size.y) return p.z < 0.0 ? 5 : 4;
    if (size.y >= size.x) return p.y < 0.0 ? 3 : 2;
    return p.x < 0.0 ? 1 : 0;
}

/// Whether a point is inside a spot's cone. p is in the axes of the spot.
bool in_cone(vec3 p, float tan2_cone)
{
    float x = p.x / p.z;
    float y = p.y / p.z;
    return p.z > 0.0 && tan2_cone >= x * x + y * y;
}
