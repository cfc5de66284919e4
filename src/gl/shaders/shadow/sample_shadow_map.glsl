// sample_shadow_map.glsl - the visibility of a light by its shadow maps, as
// shadow/map/sample_shadow_map.cpp.
//
// source  Robert and Schoepke 2006, section 4.2.1; Reeves, Salesin and Cook 1987 (N x N)

#if FIRSTHIT_FEW_LIGHTS
layout(std140, binding = kMapsBlock) uniform Maps { MapData map_data[kFaces * FIRSTHIT_FEW_LIGHTS]; };
#else
layout(std430, binding = kMapsBlock) readonly buffer Maps { MapData map_data[]; };
#endif
layout(binding = kMapDepthUnit) uniform samplerBuffer map_depth;

const float kRounding = 9.5367431640625e-7; // 2^-20, the same as in shadow/map/sample_shadow_map.cpp

/// The receiver slope that slope_bias needs; -1 if the light is not on the eye's side of the plane.
float receiver_slope_of(LightData light, SurfaceHit seen)
{
    vec3 n = seen.surface.geometric;
    float along = dot(n, light.frame_z);
    float size = abs(dot(n, light.frame_x)) + abs(dot(n, light.frame_y)) + abs(along);
    float height =
        light.kind == kDirectionalLight ? along : dot(n, seen.corner - light.position);
    // The normal points towards the eye, so the light must shine against it.
    return height < 0.0 ? min(size / -height, 1e30) : -1.0;
}

/// Index of texel (x, y) of a map. Texels are stored in quads of 4 x 4, see
/// shadow/map/store_depth.h.
int texel_offset(MapData map, int x, int y)
{
    int quads = (map.width + 3) / 4;
    int quad = (y >> 2) * quads + (x >> 2);
    return int(map.first) + quad * 16 + (y & 3) * 4 + (x & 3);
}

int clamped(float x, int most)
{
    return int(max(x < float(most) ? x : float(most), 0.0)); // NaN gives `most`
}

/// The fraction of the texels around the point that show no triangle in front of it.
float visible_fraction(MapData map, bool parallel, vec3 eye_d, float t, float receiver_slope)
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
            lit += is_shadowed_by_texel(nearest, depth, epsilon) ? 0.0 : 1.0;
        }
    }
    lit /= float(n * n);
    // Points without a shadow ray (exact/shadow_ray.h) are lit.
    bool near = abs(depth) < 1e30 && (parallel || depth > 0.0);
    return near ? lit : 1.0;
}

/// The visibility of a light from a hit, 0 to 1.
/// light_id  number of the light; the maps of its faces start at map_data[kFaces * light_id]
float sample_shadow_map(int light_id, LightData light, vec3 eye_d, float t, SurfaceHit seen)
{
    float receiver_slope = receiver_slope_of(light, seen);
    if (!(receiver_slope > 0.0)) return 0.0;
    vec3 p = transform_ray(light.to_frame, eye_d, t);
    if (light.tan2_cone > 0.0 && !in_cone(p, light.tan2_cone)) return 0.0;
    int face = light.only_face >= 0 ? light.only_face : face_of(p);
    MapData map = map_data[kFaces * light_id + face];
    if (map.width == 0) return 1.0;
    return visible_fraction(map, light.kind == kDirectionalLight, eye_d, t, receiver_slope);
}
