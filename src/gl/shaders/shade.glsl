// shade.glsl - computes the colour of a sample, as src/shade/shade_block-inl.h.

/// The visibility of a light from the hit, 0 to 1.
float lit_by(int light_id, ivec2 sample_at, Hit hit, SurfaceHit seen)
{
#if FIRSTHIT_SHADOW_MAPS
    return sample_shadow_map(light_id, light_data[light_id], eye_direction(sample_at), hit.t, seen);
#else
    return 1.0; // without shadows, every light reaches every point
#endif
}

/// The colour of the texture and of the vertices at the hit, which multiplies the colours of a
/// material without maps; 1 without both.
vec3 texture_of(SurfaceHit seen)
{
#if FIRSTHIT_TEXTURES
    if (map_count(seen.model) == 0) {
        int texture_id = material_texture(seen.material);
        if (texture_id >= 0)
            return sample_texture(texture_id, seen.surface.uv, seen.footprint2).rgb * seen.color;
    }
#endif
    return seen.color;
}

/// The material at a point.
Inputs material_at(SurfaceHit seen)
{
    return inputs_of(seen.material, texture_of(seen), seen.maps);
}

/// The light that the sample sends to the eye, linear Rec.709.
vec3 shade(ivec2 sample_at, Hit hit, SurfaceHit seen)
{
    Inputs inputs = material_at(seen);
#if FIRSTHIT_ENVIRONMENT
    bool surrounded_too = reflects_environment(inputs);
    vec3 color = emitted(inputs, surrounded_too ? vec3(0.0) : frame.ambient);
    if (surrounded_too)
        color += surrounded(inputs,
            around_light(EnvironmentTables(0), seen.surface.normal, seen.surface.to_eye,
                roughness(inputs)));
#else
    const bool surrounded_too = false;
    vec3 color = emitted(inputs, frame.ambient);
#endif
    // Nothing hides the sky here.
    if (frame.sky != 0 && !surrounded_too && reflects(inputs)) {
        float n_up = dot(seen.surface.normal, frame.sky_up);
        color += scattered(inputs,
            frame.sky_color * (0.5 + 0.5 * n_up) + frame.sky_ground * (0.5 - 0.5 * n_up));
    }
    int lights = reflects(inputs) ? frame.lights : 0;
    for (int id = 0; id < lights; ++id) {
        // Find the share of the light that arrives, and the direction to the light.
        float share = lit_by(id, sample_at, hit, seen);
        if (share <= 0.0) continue;
        LightData light = light_data[id];
        vec3 to_light = light.to_light;
        if (light.kind != kDirectionalLight) {
            vec3 d = seen.surface.position - light.position;
            bool fades = light.inv_range2 >= 0.0;
            if (light.kind == kSpotLight) {
                float versed = versine(light.axis, d);
                share *= fades ? squared_cone_share(versed, light.outer, light.inv_width)
                               : cone_share(versed, light.outer, light.inv_width);
            }
            if (fades) share *= inverse_square(dot(d, d), light.inv_range2);
            if (share <= 0.0) continue;
            to_light = unit(-d);
        }

#if FIRSTHIT_SHADOW_MAPS
        share *= terminator_share(seen.surface, to_light);
#endif
        color += reflected(inputs, seen.surface, to_light, light.color) * share;
    }
    return color;
}
