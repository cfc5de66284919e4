// phong.glsl - Phong's model: ambient, diffuse and specular light.
//
// source  Phong 1975, "Illumination for Computer Generated Pictures"

struct PhongInputs {
    vec3 ambient;
    real3 texture_color;
    real3 diffuse;
    real3 specular;
    bool glossy; // specular is not black
    int whole;   // the exponent if it is a whole number up to 64, else -1
    float shininess;
};

/// Returns the exponent if it is a whole number of at most 64, else -1. Up to 64, repeated squaring
/// is faster than steady_pow and as accurate: each product adds a relative error of at most 6e-8.
/// Negative exponents and NaN count as 0.
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

/// The light that it sends to the eye without any light source: the ambient light that it reflects.
FIRSTHIT_PURE real3 emitted(PhongInputs inputs, vec3 ambient_light)
{
    return all_lanes(inputs.ambient * ambient_light) * inputs.texture_color;
}

/// What it sends to the eye of light that comes from all sides of the sky (firsthit/options/sky_options.h).
FIRSTHIT_PURE real3 scattered(PhongInputs inputs, real3 light)
{
    return inputs.diffuse * light;
}

/// The cosine N.L, or 0 if the light is behind the shading normal. Whether the triangle's plane
/// faces the light is not considered: that changes abruptly from one triangle to the next, where a
/// smooth surface should fade.
FIRSTHIT_PURE real n_dot_l(real3 n, real3 to_light)
{
    return max(dot(n, to_light), 0.0f);
}

/// The specular term (R.V)^shininess, or 0 if `cosine`, the n_dot_l of the same point, is 0.
///
/// whole  see whole_exponent
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

/// The light of one light source that it reflects to the eye.
FIRSTHIT_PURE real3 reflected(PhongInputs inputs, Surface surface, real3 to_light, real3 light)
{
    real cosine = n_dot_l(surface.normal, to_light);
    real specular_weight = real(0.0f);
    if (inputs.glossy)
        specular_weight = highlight(surface.normal, surface.to_eye, to_light, cosine, inputs.whole,
            real(inputs.shininess));
    return light * (inputs.diffuse * cosine + inputs.specular * specular_weight);
}
