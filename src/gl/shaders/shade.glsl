// shade.glsl - what colour is it? src/shade/phong_block-inl.h, for a pixel.
//
// source  Phong 1975, "Illumination for Computer Generated Pictures"

/// How much of a light the shadows leave.
float lit_by(int light_id, ivec2 sample_at, Hit hit, Surface surface)
{
#if FIRSTHIT_SHADOW_MAPS
    return sample_shadow_map(light_id, light_data[light_id], eye_direction(sample_at), hit.t, surface);
#else
    return 1.0; // every light reaches everything
#endif
}

/// The material's diffuse colour is multiplied by this.
vec3 texture_of(Surface surface)
{
#if FIRSTHIT_TEXTURES
    int texture_id = material_texture(surface.material);
    if (texture_id >= 0) return sample_texture(texture_id, surface.uv, surface.footprint2);
#endif
    return vec3(1.0);
}

/// Ambient light and that of all lights.
vec3 shade(ivec2 sample_at, Hit hit, Surface surface)
{
    MaterialData material = material_data(surface.material);
    vec3 texture_color = texture_of(surface);
    vec3 diffuse = material.diffuse * texture_color;
    bool glossy = material.specular != vec3(0.0);

    vec3 color = material.ambient * frame.ambient * texture_color;
    for (int id = 0; id < frame.lights; ++id) {
        // How much of it arrives, and from where.
        float share = lit_by(id, sample_at, hit, surface);
        if (share <= 0.0) continue;
        LightData light = light_data[id];
        vec3 to_light = light.to_light;
        if (light.kind != kDirectionalLight) {
            vec3 d = surface.position - light.position;
            if (light.kind == kSpotLight)
                share *= cone_share(versine(light.axis, d), light.outer, light.inv_width);
            if (share <= 0.0) continue;
            to_light = unit(-d);
        }

        float cosine = n_dot_l(surface.normal, to_light);
        float specular_weight = 0.0;
        if (glossy)
            specular_weight = highlight(surface.normal, surface.to_eye, to_light, cosine,
                material.whole_shininess, material.shininess);
        color += reflected(light.color, diffuse, cosine, material.specular, specular_weight) * share;
    }
    return color;
}
