// find_surface.glsl - the triangle behind a hit, as shading sees it: src/shade/run_setup.h, for a pixel.

struct SurfaceHit {
    Surface surface;
    vec3 corner; // one of the triangle, world space
    float footprint2; // see texture.glsl
    uint material;
};

/// n scaled so that its largest coordinate is 1: the squares of tiny and of huge numbers are no
/// floats.
vec3 scaled(vec3 n)
{
    float largest = max(abs(n.x), max(abs(n.y), abs(n.z)));
    return largest > 0.0 ? n / largest : vec3(0.0);
}

/// The footprint's gradients for one step to the next sample: in eye space a sample is a unit.
float surface_footprint2(uvec3 corner, Hit hit, vec2 uv1, vec2 uv2, vec2 uv, vec2 texels)
{
    vec3 p0 = eye_position(corner.x);
    vec3 e1 = eye_position(corner.y) - p0;
    vec3 e2 = eye_position(corner.z) - p0;
    vec3 n = cross(e1, e2);
    float inv_volume = 1.0 / dot(n, p0);
    vec2 w1 = cross(e2, p0).xy * inv_volume;
    vec2 w2 = cross(p0, e1).xy * inv_volume;
    return footprint2(uv.x, uv.y, hit.t, w1 * uv1.x + w2 * uv2.x, w1 * uv1.y + w2 * uv2.y,
        n.xy * inv_volume, texels);
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

    // The plane, and the side of it that the eye is on: the same for all samples.
    uvec3 corner = triangle_corners(hit.item);
    seen.corner = world_position(corner.x);
    vec3 n = unit(cross(scaled(world_position(corner.y) - seen.corner),
        scaled(world_position(corner.z) - seen.corner)));
    surface.geometric = dot(n, d) > 0.0 ? -n : n;

    vec3 n0 = world_normal(corner.x);
    vec3 n1 = world_normal(corner.y);
    vec3 n2 = world_normal(corner.z);
    vec3 normal = n0 + ((n1 - n0) * hit.u + (n2 - n0) * hit.v);
    // Normals go by the plane's side, not by the winding, which in real files opposes some of them.
    if (dot(n0 + n1 + n2, surface.geometric) < 0.0) normal = -normal;
    surface.normal = visible_normal(normal, surface.geometric, surface.to_eye);

    seen.material = triangle_material(hit.item);
    surface.uv = vec2(0.0);
    seen.footprint2 = 0.0;
#if FIRSTHIT_TEXTURES
    {
        vec2 uv0 = vertex_uv(corner.x);
        vec2 uv1 = vertex_uv(corner.y) - uv0;
        vec2 uv2 = vertex_uv(corner.z) - uv0;
        vec2 uv = uv1 * hit.u + uv2 * hit.v;
        surface.uv = uv0 + uv;
        int texture_id = material_texture(seen.material);
        if (texture_id >= 0)
            seen.footprint2 =
                surface_footprint2(corner, hit, uv1, uv2, uv, texture_size(texture_id));
    }
#endif
    seen.surface = surface;
    return seen;
}
