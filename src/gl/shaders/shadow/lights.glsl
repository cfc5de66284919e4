// lights.glsl - the lights and their shadow maps.
#include "gl/layouts.glsl"

// FIRSTHIT_FEW_LIGHTS: they fit into uniform blocks, which are faster.
#if FIRSTHIT_FEW_LIGHTS
layout(std140, binding = 1) uniform Lights { LightData light_data[FIRSTHIT_FEW_LIGHTS]; };
#else
layout(std430, binding = 1) readonly buffer Lights { LightData light_data[]; };
#endif

/// Where the ray of eye direction (X, Y, 1) is at depth t, in a light's space.
vec3 transform_ray(Rays to, vec3 eye_d, float t)
{
    return to.eye + t * ((eye_d.x * to.right + eye_d.y * to.down) + to.forward);
}

/// The face of a light that a point of its axes lies on.
int face_of(vec3 p)
{
    vec3 size = abs(p);
    if (size.z >= size.x && size.z >= size.y) return p.z < 0.0 ? 5 : 4;
    if (size.y >= size.x) return p.y < 0.0 ? 3 : 2;
    return p.x < 0.0 ? 1 : 0;
}

/// Whether a point of a spot's axes is inside its cone.
bool in_cone(vec3 p, float tan2_cone)
{
    float x = p.x / p.z;
    float y = p.y / p.z;
    return p.z > 0.0 && tan2_cone >= x * x + y * y;
}
