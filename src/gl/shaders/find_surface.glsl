// find_surface.glsl - the surface at a hit: position, normals, texture coordinates, material.
// Computes for a sample what src/shade/run_setup.h computes for a run.

struct SurfaceHit {
    Surface surface;
    vec3 corner; // one of the triangle, world space
    float footprint2; // see texture.glsl; of materials without maps
    uint material;
    int model;      // of the material
    MapColors maps;      // of models with maps; colours of vertices are in the first
    vec3 color;     // of the vertices
};

/// n scaled so that its largest coordinate is 1, because squares of very small and very large
/// numbers under- or overflow.
vec3 scaled(vec3 n)
{
    float largest = max(abs(n.x), max(abs(n.y), abs(n.z)));
    return largest > 0.0 ? n / largest : vec3(0.0);
}

/// The gradients of texture coordinates over a triangle, for footprint2.
struct UvGradients {
    vec2 u, v, one;
};

/// In eye space the step from sample to sample is 1.
UvGradients uv_gradients(uvec3 corner, vec2 uv1, vec2 uv2)
{
    vec3 p0 = eye_position(corner.x);
    vec3 e1 = eye_position(corner.y) - p0;
    vec3 e2 = eye_position(corner.z) - p0;
    vec3 n = cross(e1, e2);
    float inv_volume = 1.0 / dot(n, p0);
    vec2 w1 = cross(e2, p0).xy * inv_volume;
    vec2 w2 = cross(p0, e1).xy * inv_volume;
    return UvGradients(w1 * uv1.x + w2 * uv2.x, w1 * uv1.y + w2 * uv2.y, n.xy * inv_volume);
}

/// Texture coordinates at a hit, and their steps to the next sample.
struct UvHit {
    vec2 uv;
    vec2 step_u, step_v;
};

UvHit uv_hit(uvec3 corner, Hit hit, vec2 uv0, vec2 uv1, vec2 uv2)
{
    vec2 uv = uv1 * hit.u + uv2 * hit.v;
    UvGradients g = uv_gradients(corner, uv1, uv2);
    UvHit at;
    at.uv = uv0 + uv;
    at.step_u = vec2(texture_step(uv.x, hit.t, g.u.x, g.one.x), texture_step(uv.x, hit.t, g.u.y, g.one.y));
    at.step_v = vec2(texture_step(uv.y, hit.t, g.v.x, g.one.x), texture_step(uv.y, hit.t, g.v.y, g.one.y));
    return at;
}

/// The texture of a map, or -1.
int map_texture(uint material, int number)
{
    int first = kMaterialTexels * int(material) + kFirstMapTexel + kMapTexels * number;
    return floatBitsToInt(texelFetch(materials, first + 1).z);
}

/// One of the maps of a material: material/texels.h.
MapColor sample_map(uint material, int number, UvHit uv_hits[2])
{
    int first = kMaterialTexels * int(material) + kFirstMapTexel + kMapTexels * number;
    vec4 per = texelFetch(materials, first);
    vec4 rest = texelFetch(materials, first + 1);
    int texture_id = floatBitsToInt(rest.z);
    MapColor color = MapColor(vec3(1.0), 1.0);
    if (texture_id < 0) return color;
    UvHit at = uv_hits[0];
    if (floatBitsToInt(rest.w) != 0) at = uv_hits[1];
    float length2 = moved_footprint2(at.step_u, at.step_v, per.xy, per.zw, texture_size(texture_id));
    vec2 uv = vec2((per.x * at.uv.x + per.z * at.uv.y) + rest.x, (per.y * at.uv.x + per.w * at.uv.y) + rest.y);
    vec4 texel = sample_texture(texture_id, uv, length2);
    return MapColor(texel.rgb, texel.a);
}

SurfaceHit find_surface(ivec2 sample_at, Hit hit)
{
    SurfaceHit seen;
    Surface surface;
    vec3 eye_d = eye_direction(sample_at);
    Rays rays = frame.rays;
    vec3 d = ray_direction(
        eye_d.x, eye_d.y, rays.step_x, rays.step_y, rays.right, rays.down, rays.forward);
    surface.position = hit_position(rays.eye, d, hit.t);
    surface.to_eye = unit(-d);

    // The normal of the plane on the eye's side: the same for all samples of the triangle.
    uvec3 corner = triangle_corners(hit.item);
    seen.corner = world_position(corner.x);
    vec3 n = unit(cross(scaled(world_position(corner.y) - seen.corner),
        scaled(world_position(corner.z) - seen.corner)));
    surface.geometric = dot(n, d) > 0.0 ? -n : n;

    vec3 n0 = world_normal(corner.x);
    vec3 n1 = world_normal(corner.y);
    vec3 n2 = world_normal(corner.z);
    vec3 normal = n0 + ((n1 - n0) * hit.u + (n2 - n0) * hit.v);
    // Turn the normal to the eye's side of the plane. The order of corners does not matter, because
    // in real files some normals contradict it.
    float side = dot(n0 + n1 + n2, surface.geometric) < 0.0 ? -1.0 : 1.0;
    normal *= side;
    float most = max(side * dot(n0, surface.geometric),
        max(side * dot(n1, surface.geometric), side * dot(n2, surface.geometric)));
    surface.flat_normal = surface.geometric;
    surface.bend = most > 0.0 ? min(sqrt(max(1.0 - most * most, 0.0)), 0.45) : 0.0;

    seen.material = triangle_material(hit.item);
    seen.model = material_model(seen.material);
    seen.color = vec3(1.0);
#if FIRSTHIT_VERTEX_COLORS
    {
        vec3 c0 = vertex_color(corner.x);
        seen.color = c0 + ((vertex_color(corner.y) - c0) * hit.u + (vertex_color(corner.z) - c0) * hit.v);
    }
#endif
    surface.uv = vec2(0.0);
    seen.footprint2 = 0.0;
    for (int k = 0; k < kMostMaps; ++k) seen.maps.map[k] = MapColor(vec3(1.0), 1.0);
#if FIRSTHIT_TEXTURES
    {
        vec2 uv0 = vertex_uv(corner.x);
        vec2 uv1 = vertex_uv(corner.y) - uv0;
        vec2 uv2 = vertex_uv(corner.z) - uv0;
        vec2 uv = uv1 * hit.u + uv2 * hit.v;
        surface.uv = uv0 + uv;
        int maps = map_count(seen.model);
        if (maps == 0) {
            int texture_id = material_texture(seen.material);
            if (texture_id >= 0) {
                UvGradients g = uv_gradients(corner, uv1, uv2);
                seen.footprint2 =
                    footprint2(uv.x, uv.y, hit.t, g.u, g.v, g.one, texture_size(texture_id));
            }
        } else {
            UvHit uv_hits[2];
            uv_hits[0] = uv_hit(corner, hit, uv0, uv1, uv2);
            uv_hits[1] = uv_hits[0];
#if FIRSTHIT_SECOND_UV
            vec2 second0 = vertex_second_uv(corner.x);
            uv_hits[1] = uv_hit(corner, hit, second0, vertex_second_uv(corner.y) - second0,
                vertex_second_uv(corner.z) - second0);
#endif
            for (int k = 0; k < maps; ++k) seen.maps.map[k] = sample_map(seen.material, k, uv_hits);
#if FIRSTHIT_TANGENTS
            int number = normal_map(seen.model);
            if (number >= 0 && map_texture(seen.material, number) >= 0) {
                vec4 t0 = world_tangent(corner.x);
                vec3 t1 = world_tangent(corner.y).xyz - t0.xyz;
                vec3 t2 = world_tangent(corner.z).xyz - t0.xyz;
                normal = mapped_normal(normal, side * (t0.xyz + (t1 * hit.u + t2 * hit.v)),
                    side * t0.w, seen.maps.map[number].rgb,
                    normal_scale(seen.material, seen.model));
            }
#endif
        }
    }
#endif
    seen.maps.map[0].rgb *= seen.color;
    surface.normal = visible_normal(normal, surface.geometric, surface.to_eye);
    seen.surface = surface;
    return seen;
}
