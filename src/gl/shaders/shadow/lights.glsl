// lights.glsl - the lights and their shadow maps. The layouts are those of gl/scene/gpu_data.h.

const int kPointLight = 0;
const int kSpotLight = 1;
const int kDirectionalLight = 2;
const int kFaces = 6; // of a light; see shadow/map/light_frame.h

struct LightData {
    Rays to_frame; // in the light's axes; steps are 1, as those of maps
    vec3 color;
    int kind;
    vec3 position; // world space
    float tan2_cone; // square of a spot's tangent where its maps end; 0: no cone
    vec3 to_light; // directional: unit
    int only_face; // the face of all hits; -1: each hit has its own
    vec3 axis; // spot: unit, the way the light goes
    float outer; // spot: see spot_cone.glsl
    vec3 frame_x; // rows of frame_from_world
    float inv_width;
    vec3 frame_y;
    int cube; // six faces
    vec3 frame_z;
    int unused;
};

struct MapData {
    Rays to_map; // in (texel x, texel y, depth), the first two times the depth
    uint first; // of its texels in map_depth
    int width; // 0: no map
    int height;
    float reach; // of slope_bias
    float rounding; // added to it
    int unused0, unused1, unused2;
};

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
