// sample_shadow_map.glsl - how much of a light reaches a point, by its maps: src/shadow/sample_shadow_map.cpp.
//
// source  Robert and Schoepke 2006, section 4.2.1; Reeves, Salesin and Cook 1987 (N x N)

#if FIRSTHIT_FEW_LIGHTS
layout(std140, binding = 2) uniform Maps { MapData map_data[kFaces * FIRSTHIT_FEW_LIGHTS]; };
#else
layout(std430, binding = 2) readonly buffer Maps { MapData map_data[]; };
#endif
layout(binding = 13) uniform samplerBuffer map_depth;

const float kRounding = 9.5367431640625e-7; // 2^-20

/// Steepness as slope_bias takes it; -1 where the light is not on the eye's side of the plane.
float receiver_slope_of(LightData light, SurfaceHit seen)
{
    vec3 n = seen.surface.geometric;
    float along = dot(n, light.frame_z);
    float size = abs(dot(n, light.frame_x)) + abs(dot(n, light.frame_y)) + abs(along);
    float height =
        light.kind == kDirectionalLight ? along : dot(n, seen.corner - light.position);
    // The normal looks towards the eye: the light's way has to be against it.
    return height < 0.0 ? min(size / -height, 1e30) : -1.0;
}

/// Where texel (x, y) is in a map: quads of 4 x 4, see shadow/map/store_depth.h.
int texel_offset(MapData map, int x, int y)
{
    int quads = (map.width + 3) / 4;
    int quad = (y >> 2) * quads + (x >> 2);
    return int(map.first) + quad * 16 + (y & 3) * 4 + (x & 3);
}

int clamped(float x, int most)
{
    return int(max(x < float(most) ? x : float(most), 0.0)); // no number: most
}

/// The share of the texels around the point that show nothing before it.
float lit_share(MapData map, bool parallel, vec3 eye_d, float t, float receiver_slope)
{
    vec3 p = transform_ray(map.to_map, eye_d, t);
    float depth = p.z;
    vec2 texel = p.xy;
    if (!parallel) texel *= 1.0 / depth;
    float epsilon = frame.bias;
    if (frame.bias < 0.0)
        epsilon = slope_bias(parallel ? 1.0 : depth, receiver_slope, map.reach) +
                  (depth * kRounding + map.rounding);

    int n = frame.filter_size;
    vec2 first = floor(texel - 0.5 * float(n - 1));
    float lit = 0.0;
    for (int j = 0; j < n; ++j) {
        int y = clamped(first.y + float(j), map.height - 1);
        for (int i = 0; i < n; ++i) {
            int x = clamped(first.x + float(i), map.width - 1);
            float nearest = texelFetch(map_depth, texel_offset(map, x, y)).x;
            lit += is_shadowed(nearest, depth, epsilon) ? 0.0 : 1.0;
        }
    }
    lit /= float(n * n);
    // Without a shadow ray.
    bool near = abs(depth) < 1e30 && (parallel || depth > 0.0);
    return near ? lit : 1.0;
}

/// light_id  its faces' maps are map_data[6 light_id] and on
float sample_shadow_map(int light_id, LightData light, vec3 eye_d, float t, SurfaceHit seen)
{
    float receiver_slope = receiver_slope_of(light, seen);
    if (!(receiver_slope > 0.0)) return 0.0;
    vec3 p = transform_ray(light.to_frame, eye_d, t);
    if (light.tan2_cone > 0.0 && !in_cone(p, light.tan2_cone)) return 0.0;
    int face = light.only_face >= 0 ? light.only_face : face_of(p);
    MapData map = map_data[kFaces * light_id + face];
    if (map.width == 0) return 1.0;
    return lit_share(map, light.kind == kDirectionalLight, eye_d, t, receiver_slope);
}
