// phong.glsl - Phong's model: ambient, diffuse and specular light.
//
// source  Phong 1975, "Illumination for Computer Generated Pictures"

struct PhongInputs {
    vec3 ambient;
    real3 texture_color;
    real3 diffuse;
    real3 specular;
    bool glossy; // specular is not black
    int whole;   // the exponent if it is whole and small, else -1
    float shininess;
};

/// The exponent if it is whole and at most 64, else -1. To there squaring is faster than steady_pow,
/// and as exact: each product adds at most 6e-8. An exponent below 0, or one that is no number,
/// counts as 0.
FIRSTHIT_PURE int whole_exponent(float shininess)
{
    if (!(shininess > 0.0f)) return 0;
    if (shininess > 64.0f) return -1;
    int whole = int(shininess);
    return float(whole) == shininess ? whole : -1;
}

FIRSTHIT_PURE PhongInputs inputs_of(Phong material, real3 texture_color)
{
    PhongInputs inputs;
    inputs.ambient = material.ambient;
    inputs.texture_color = texture_color;
    inputs.diffuse = all_lanes(material.diffuse) * texture_color;
    inputs.specular = all_lanes(material.specular);
    inputs.glossy = material.specular != vec3(0.0f);
    inputs.whole = whole_exponent(material.shininess);
    inputs.shininess = material.shininess;
    return inputs;
}

FIRSTHIT_PURE real3 albedo(PhongInputs inputs)
{
    return inputs.diffuse;
}

/// What it sends to the eye whatever the lights are: its part of the ambient light.
FIRSTHIT_PURE real3 emitted(PhongInputs inputs, vec3 ambient_light)
{
    return all_lanes(inputs.ambient * ambient_light) * inputs.texture_color;
}

/// N.L, or 0 where the light is behind the shading normal. The triangle's plane has no say: whether
/// it faces the light changes at once from triangle to triangle, where a smooth surface should fade.
FIRSTHIT_PURE real n_dot_l(real3 n, real3 to_light)
{
    return max(dot(n, to_light), 0.0f);
}

/// (R.V)^shininess, or 0 where `cosine`, the n_dot_l of the same point, is 0.
///
/// whole  the exponent if it is whole and small (the error grows with it), else -1
FIRSTHIT_PURE real highlight(
    real3 n, real3 to_eye, real3 to_light, real cosine, int whole, real shininess)
{
    real r_v = 2.0f * cosine * dot(n, to_eye) - dot(to_light, to_eye);
    real base = min(max(r_v, 0.0f), 1.0f);
    real power = real(0.0f);
    if (whole >= 0)
        power = steady_pow_whole(base, whole);
    else
        power = steady_pow(base, shininess);
    return mix(real(0.0f), power, cosine > real(0.0f));
}

/// What it sends to the eye of one light.
FIRSTHIT_PURE real3 reflected(PhongInputs inputs, Surface surface, real3 to_light, real3 light)
{
    real cosine = n_dot_l(surface.normal, to_light);
    real specular_weight = real(0.0f);
    if (inputs.glossy)
        specular_weight = highlight(surface.normal, surface.to_eye, to_light, cosine, inputs.whole,
            real(inputs.shininess));
    return light * (inputs.diffuse * cosine + inputs.specular * specular_weight);
}
