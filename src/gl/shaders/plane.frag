// plane.frag - draws one plane of the film. FIRSTHIT_PLANE is its number in the enum Aov
// (firsthit/film.h).
#include "frame.glsl"
#include "scene.glsl"
#include "intersect.glsl"
#include "items.glsl"
#include "find_hit.glsl"
#include "hit_position.glsl"
#include "spot_cone.glsl"
#include "falloff.glsl"
#include "power.glsl"
#include "texture.glsl"
#include "shadow_map.glsl"
#include "surface.glsl"
#include "materials.glsl"
#include "models.glsl"
#include "environment_tables.glsl"
#include "sample_texture.glsl"
#include "find_surface.glsl"
#include "lights.glsl"
#include "sample_shadow_map.glsl"
#include "shade.glsl"

#if FIRSTHIT_PLANE == 0
layout(location = 0) out uvec4 plane_out;
#else
layout(location = 0) out vec4 plane_out;
layout(location = kPlaneLight) uniform int light_id; // for the plane `lit`
#endif

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    Hit hit = find_hit(at);
#if FIRSTHIT_PLANE == 0 // item
    plane_out = uvec4(is_hit(hit) ? hit.item : kNoItem);
#elif FIRSTHIT_PLANE == 1 // depth
    plane_out = vec4(is_hit(hit) ? hit.t : uintBitsToFloat(0x7F800000u));
#elif FIRSTHIT_PLANE == 2 // distance
    vec2 d = eye_direction(at).xy * vec2(frame.rays.step_x, frame.rays.step_y);
    d += vec2(d.y * frame.shear.x + frame.shear.y, frame.shear.z);
    plane_out = vec4(is_hit(hit) ? hit.t * sqrt(1.0 + dot(d, d)) : uintBitsToFloat(0x7F800000u));
#elif FIRSTHIT_PLANE == 8 // barycentric
    plane_out = is_hit(hit) ? vec4(hit.u, hit.v, 0.0, 0.0) : vec4(0.0);
#else
    plane_out = vec4(0.0);
    if (!is_hit(hit)) return;
    SurfaceHit seen = find_surface(at, hit);
    Surface surface = seen.surface;
#if FIRSTHIT_PLANE == 3 // uv
    plane_out.xy = surface.uv;
#elif FIRSTHIT_PLANE == 4 // normal
    plane_out.xyz = surface.normal;
#elif FIRSTHIT_PLANE == 5 // geometric_normal
    plane_out.xyz = surface.geometric;
#elif FIRSTHIT_PLANE == 6 // position
    plane_out.xyz = surface.position;
#elif FIRSTHIT_PLANE == 7 // albedo
    plane_out.xyz = albedo(material_at(seen));
#elif FIRSTHIT_PLANE == 14 // metallic_roughness
    Inputs inputs = material_at(seen);
    plane_out.xy = vec2(metallic(inputs), roughness(inputs));
#elif FIRSTHIT_PLANE == 15 // emission
    plane_out.xyz = emission(material_at(seen));
#elif FIRSTHIT_PLANE == 9 // lit
    plane_out.x = lit_by(light_id, at, hit, seen);
#endif
#endif
}
