// metallic_roughness.glsl - the model of glTF 2.0: a metal, or a dielectric over a scattering base.
//
// source  Khronos 2021, "glTF 2.0 Specification", appendix B, with what KHR_materials_specular adds;
//         Trowbridge and Reitz 1975 (distribution), Smith 1967 (shadowing), Schlick 1994 (Fresnel);
//         Guy and Agopian 2018, "Physically Based Rendering in Filament" (least roughness);
//         Karis 2013, "Real Shading in Unreal Engine 4" (split sum)

struct MetallicRoughnessInputs {
    real3 base_color;
    real3 scattered; // by the base, of what the coat lets through; over pi
    real3 emission;
    real occlusion;
    real coat;    // what a dielectric's coat reflects straight back, of the channel with most
    real coat90;  // and at grazing angles
    real3 f0;     // of dielectric and metal
    real f90;
    real alpha2;  // square of the width of the microfacets' slopes
    real metallic;
    real roughness;
};

FIRSTHIT_PURE real clamp_share(real x)
{
    return min(max(x, 0.0f), 1.0f);
}

FIRSTHIT_PURE MetallicRoughnessInputs inputs_of(MetallicRoughness material, MapColors maps)
{
    MetallicRoughnessInputs inputs;
    inputs.base_color = all_lanes(material.base_color) * maps.map[0].rgb;
    real metallic = clamp_share(material.metallic * maps.map[1].rgb.z);
    inputs.metallic = metallic;
    inputs.roughness = clamp_share(material.roughness * maps.map[1].rgb.y);
    // Below this a highlight is smaller than any pixel, and floats do not hold its height.
    real roughness = max(inputs.roughness, 0.045f);
    inputs.occlusion =
        1.0f + material.occlusion_strength * (maps.map[3].rgb.x - 1.0f);
    inputs.emission = all_lanes(material.emission) * maps.map[4].rgb;

    real dielectric = 1.0f - metallic;
    real3 coat = all_lanes(material.f0) * maps.map[5].rgb;
    inputs.coat90 = material.specular * maps.map[5].alpha;
    coat = real3(min(coat.x, 1.0f), min(coat.y, 1.0f), min(coat.z, 1.0f)) * inputs.coat90;
    inputs.coat = max(coat.x, max(coat.y, coat.z));
    inputs.f0 = coat * dielectric + inputs.base_color * metallic;
    inputs.f90 = inputs.coat90 * dielectric + metallic;
    inputs.scattered = inputs.base_color * (dielectric * 0.318309886f);
    real alpha = roughness * roughness;
    inputs.alpha2 = alpha * alpha;
    return inputs;
}

FIRSTHIT_PURE real3 albedo(MetallicRoughnessInputs inputs)
{
    return inputs.base_color;
}

FIRSTHIT_PURE real metallic(MetallicRoughnessInputs inputs)
{
    return inputs.metallic;
}

FIRSTHIT_PURE real roughness(MetallicRoughnessInputs inputs)
{
    return inputs.roughness;
}

FIRSTHIT_PURE real3 emission(MetallicRoughnessInputs inputs)
{
    return inputs.emission;
}

/// What it sends to the eye of the light from all around. Nothing shadows it but the occlusion.
FIRSTHIT_PURE real3 surrounded(MetallicRoughnessInputs inputs, AroundLight around)
{
    real let_through = 1.0f - (inputs.coat * around.per_f0 + inputs.coat90 * around.per_f90);
    real edge = inputs.f90 * around.per_f90;
    real3 mirrored = inputs.f0 * around.per_f0 + real3(edge, edge, edge);
    // `scattered` is over pi, and `diffuse` is, too.
    return (inputs.scattered * around.diffuse * (3.14159265f * let_through) +
               mirrored * around.specular) *
           inputs.occlusion;
}

/// What it sends to the eye whatever the lights are. Of the ambient light there is a tenth, as of
/// Phong's without a file that says more; it comes from all sides, so that metals reflect it too.
/// Where there is an environment, there is no ambient light.
FIRSTHIT_PURE real3 emitted(MetallicRoughnessInputs inputs, vec3 ambient_light)
{
    return inputs.emission +
           inputs.base_color * (all_lanes(ambient_light) * (inputs.occlusion * 0.1f));
}

/// What it sends to the eye of light that comes from all sides of the sky (firsthit/options/sky_options.h).
FIRSTHIT_PURE real3 scattered(MetallicRoughnessInputs inputs, real3 light)
{
    return inputs.base_color * light * ((1.0f - inputs.metallic) * inputs.occlusion);
}

/// What it sends to the eye of one light.
///
/// The specification's D G / (4 n.l n.v) has (n + root) below for both directions and a square of
/// D's, one division in all. The vector between the directions is not made unit, but by the powers
/// of its length.
FIRSTHIT_PURE real3 reflected(
    MetallicRoughnessInputs inputs, Surface surface, real3 to_light, real3 light)
{
    real3 n = surface.normal;
    real n_l = max(dot(n, to_light), 0.0f);
    real n_v = max(dot(n, surface.to_eye), 0.0f);
    real a2 = inputs.alpha2;
    real root_l = sqrt(a2 + (1.0f - a2) * n_l * n_l);
    real root_v = sqrt(a2 + (1.0f - a2) * n_v * n_v);

    real3 between = to_light + surface.to_eye;
    real length2 = dot(between, between);
    real n_b = dot(n, between);
    // 1 - (n.h)^2 without the loss of digits near 1, where all of a narrow highlight is.
    real3 across = cross_product(n, between);
    real spread = max(dot(across, across) + a2 * n_b * n_b, 1.0e-12f);
    real mirrored = a2 * 0.318309886f * length2 * length2 /
                    (spread * spread * (n_l + root_l) * (n_v + root_v));

    // v.h is half the length of v + l.
    real rest = 1.0f - min(0.5f * sqrt(length2), 1.0f);
    real rest2 = rest * rest;
    real grazing = rest2 * rest2 * rest;
    real straight = 1.0f - grazing;
    real edge = inputs.f90 * grazing;
    real3 fresnel = inputs.f0 * straight + real3(edge, edge, edge);
    real let_through = 1.0f - (inputs.coat * straight + inputs.coat90 * grazing);
    return light * ((inputs.scattered * let_through + fresnel * mirrored) * n_l);
}
