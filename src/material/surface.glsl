// surface.glsl - the properties of a visible point that shading uses.
//
// The texts of this folder are compiled as GLSL 4.50 and as C++, like those of src/glsl/
// (power.glsl explains the types). In addition, vec3 is a vector that all samples of a register
// share, and all_lanes(v) converts it to a real3. The text of a model (for example phong.glsl)
// defines
//
//     struct ModelInputs                the material at a point, after texturing
//     ModelInputs inputs_of(Model material, real3 texture_color)   or, for a model with maps,
//     ModelInputs inputs_of(Model material, MapColors maps)
//     real3 albedo(ModelInputs inputs)
//     real3 emitted(ModelInputs inputs, vec3 ambient_light)
//     real3 reflected(ModelInputs inputs, Surface surface, real3 to_light, real3 light)
//     real3 scattered(ModelInputs inputs, real3 light)
//
// (the last two where it reflects lights)
// and, if it reflects environments (models.h),
//
//     real roughness(ModelInputs inputs)
//     real metallic(ModelInputs inputs)
//     real3 emission(ModelInputs inputs)
//     real3 surrounded(ModelInputs inputs, AroundLight around)
//
// `Model` is the struct of firsthit/material.h. In shaders it has only the fields that models.h
// lists. The colours of textures that are handed over are already multiplied by the colour of the
// vertices.

/// The value of one of a model's textures at a point; 1 without a texture.
struct MapColor {
    real3 rgb;
    real alpha;
};

const int kMostMaps = 6;

/// The values of all textures of a model, in the order of models.h.
struct MapColors {
    MapColor map[kMostMaps];
};

struct Surface {
    real3 position;  // world space
    real3 to_eye;    // unit
    real3 geometric; // normal of the triangle's plane, unit, towards the eye
    real3 normal;    // interpolated normal, unit, towards the eye
    real3 flat_normal; // as `geometric`, but for rounding
    real bend;         // sine of the smallest angle between the plane's normal and those of its corners;
                       // at most 0.45. On spheres and cylinders all corners have the same
    real2 uv;        // texture coordinates; 0 if the scene has none
};

/// What a surface of some roughness sees of the environment (src/glsl/environment.glsl).
struct AroundLight {
    real3 diffuse;  // what a matt white surface would send to the eye
    real3 specular; // what is reflected from around the mirror's direction, if all is reflected
    real per_f0;    // f0 per_f0 + f90 per_f90 is the share of it that is reflected
    real per_f90;
};

/// Weights of four texels around a place. Their sum is 1.
struct FourWeights {
    real top_left, top_right, bottom_left, bottom_right;
};

/// The unit vector along d; 0 for d = 0.
FIRSTHIT_PURE real3 unit(real3 d)
{
    real length2 = dot(d, d);
    return d * mix(real(0.0f), 1.0f / sqrt(length2), length2 > real(0.0f));
}

FIRSTHIT_PURE real3 cross_product(real3 a, real3 b)
{
    return real3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

/// The normal that a normal map gives; not unit.
///
/// n        interpolated; if it is 0, the result is 0
/// tangent  interpolated, on the side of the surface that n is on: flipped where n is
/// side     1 or -1, and negated where n is flipped: the bitangent is side * (n x tangent)
/// texel    0 to 1: -1 to 1 along tangent, bitangent and n
FIRSTHIT_PURE real3 mapped_normal(real3 n, real3 tangent, real side, real3 texel, real scale)
{
    real3 z = unit(n);
    real3 x = unit(tangent - z * dot(z, tangent)) * dot(z, z);
    real3 y = cross_product(z, x) * side;
    return x * (scale * (2.0f * texel.x - 1.0f)) + y * (scale * (2.0f * texel.y - 1.0f)) +
           z * (2.0f * texel.z - 1.0f);
}

/// The interpolated normal n; if it points away from the eye, its projection perpendicular to the
/// ray. Not unit.
FIRSTHIT_PURE real3 bend_to_eye(real3 n, real3 to_eye)
{
    return n - to_eye * min(dot(n, to_eye), 0.0f);
}

/// Whether the direction of a bent normal is meaningful. Below a length of 1e-6 it consists of
/// rounding errors.
FIRSTHIT_PURE truth has_direction(real3 bent)
{
    return dot(bent, bent) > real(1.0e-12f);
}

/// The unit normal that shading uses.
///
/// n          the interpolated normal, on the eye's side of the triangle's plane; need not be unit
/// geometric  unit normal of the plane, towards the eye; the result if n is 0 or points straight
///            away
FIRSTHIT_PURE real3 visible_normal(real3 n, real3 geometric, real3 to_eye)
{
    real3 bent = bend_to_eye(n, to_eye);
    real inv = 1.0f / sqrt(max(dot(bent, bent), 1.0e-12f));
    return real3(mix(geometric.x, bent.x * inv, has_direction(bent)),
        mix(geometric.y, bent.y * inv, has_direction(bent)),
        mix(geometric.z, bent.z * inv, has_direction(bent)));
}

/// From this cosine between a light and the smooth normal on, terminator_share is 1.
const float kSurelyLit = 0.7f;

/// 0 up to x = 0, 1 from x = 1 on, steady between.
FIRSTHIT_PURE real steady_step(real x)
{
    real share = min(max(x, 0.0f), 1.0f);
    return share * share * (3.0f - 2.0f * share);
}

/// The share of a light that is left where shadows of flat triangles meet smooth normals. A triangle that
/// turns away from the light is in its own shadow as a whole, where the smooth normal still sees light; its border
/// would show. Exactly 1 farther from there, and from a cosine of 0.7 on whatever the flat normal is.
///
/// Where triangles are fine, light fades with the cosine of the flat normal, as soon as it is less than half of
/// what the smooth one leads to expect. On coarse ones that leaves steps from triangle to triangle. But they are
/// in their own shadow up to a cosine of `bend` of the smooth normal, which is steady, so light fades to
/// nothing there. (On fine and on uneven ones, whose least angle is small, this would show more than it hides.)
///
/// source  Chiang, Li and Burley 2019, "Taming the Shadow Terminator" (by the flat normal)
FIRSTHIT_PURE real terminator_share(Surface surface, real3 to_light)
{
    real n_l = dot(surface.normal, to_light);
    real flat_cosine = dot(surface.flat_normal, to_light);
    real expected = n_l * dot(surface.normal, surface.flat_normal);
    real fine = steady_step(2.0f * flat_cosine / max(expected, 1.0e-6f));
    real coarse = steady_step((n_l - surface.bend) / max(0.5f * surface.bend, 1.0e-6f));
    real weight = min(max((surface.bend - 0.15f) * (1.0f / 0.15f), 0.0f), 1.0f);
    return mix(fine + (coarse - fine) * weight, real(1.0f), n_l >= real(kSurelyLit));
}
