// surface.glsl - what shading knows of a point that the eye sees.
//
// The texts of this folder are compiled as GLSL 4.50 and as C++, like those of src/glsl/, where the
// words are explained. Besides: vec3 is one vector that all samples of a register share, and
// all_lanes(v) is it as a real3. A model's text (phong.glsl) has
//
//     struct ModelInputs                what the material is at a point
//     ModelInputs inputs_of(Model material, real3 texture_color)
//     real3 albedo(ModelInputs inputs)
//     real3 emitted(ModelInputs inputs, vec3 ambient_light)
//     real3 reflected(ModelInputs inputs, Surface surface, real3 to_light, real3 light)
//
// with the struct `Model` of firsthit/material.h: in shaders it has the fields that models.h lists.

struct Surface {
    real3 position;  // world space
    real3 to_eye;    // unit
    real3 geometric; // the normal of the triangle's plane, unit, towards the eye
    real3 normal;    // interpolated, unit, towards the eye
    real2 uv;        // texture coordinates; 0 where there are none
};

/// A unit vector along d. d = 0 gives 0.
FIRSTHIT_PURE real3 unit(real3 d)
{
    real length2 = dot(d, d);
    return d * mix(real(0.0f), 1.0f / sqrt(length2), length2 > real(0.0f));
}

/// The interpolated normal n, bent just so far that the eye sees it; not unit.
FIRSTHIT_PURE real3 bend_to_eye(real3 n, real3 to_eye)
{
    return n - to_eye * min(dot(n, to_eye), 0.0f);
}

/// Whether a bent normal is one: below a millionth of a unit normal only rounding is left of its
/// direction.
FIRSTHIT_PURE truth has_direction(real3 bent)
{
    return dot(bent, bent) > real(1.0e-12f);
}

/// The unit shading normal.
///
/// n         on the eye's side of the triangle's plane (its side was chosen with the plane's)
/// geometric the plane's unit normal, towards the eye; the answer where n is 0 or points away
FIRSTHIT_PURE real3 visible_normal(real3 n, real3 geometric, real3 to_eye)
{
    real3 bent = bend_to_eye(n, to_eye);
    real inv = 1.0f / sqrt(max(dot(bent, bent), 1.0e-12f));
    return real3(mix(geometric.x, bent.x * inv, has_direction(bent)),
        mix(geometric.y, bent.y * inv, has_direction(bent)),
        mix(geometric.z, bent.z * inv, has_direction(bent)));
}
