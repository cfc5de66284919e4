// shade.glsl - what colour is it? src/shade/shade_block-inl.h, for a pixel.

/// How much of a light the shadows leave.
float lit_by(int light_id, ivec2 sample_at, Hit hit, SurfaceHit seen)
{
#if FIRSTHIT_SHADOW_MAPS
    return sample_shadow_map(light_id, light_data[light_id], eye_direction(sample_at), hit.t, seen);
#else
    return 1.0; // every light reaches everything
#endif
}

/// The material's colours are multiplied by this.
vec3 texture_of(SurfaceHit seen)
{
#if FIRSTHIT_TEXTURES
    int texture_id = material_texture(seen.material);
    if (texture_id >= 0) return sample_texture(texture_id, seen.surface.uv, seen.footprint2);
#endif
    return vec3(1.0);
}

/// The light that the sample sends to the eye.
vec3 shade(ivec2 sample_at, Hit hit, SurfaceHit seen)
{
    Inputs inputs = inputs_of(seen.material, texture_of(seen));
    vec3 color = emitted(inputs, frame.ambient);
    int lights = reflects(inputs) ? frame.lights : 0;
    for (int id = 0; id < lights; ++id) {
        // How much of it arrives, and from where.
        float share = lit_by(id, sample_at, hit, seen);
        if (share <= 0.0) continue;
        LightData light = light_data[id];
        vec3 to_light = light.to_light;
        if (light.kind != kDirectionalLight) {
            vec3 d = seen.surface.position - light.position;
            if (light.kind == kSpotLight)
                share *= cone_share(versine(light.axis, d), light.outer, light.inv_width);
            if (share <= 0.0) continue;
            to_light = unit(-d);
        }

        color += reflected(inputs, seen.surface, to_light, light.color) * share;
    }
    return color;
}
