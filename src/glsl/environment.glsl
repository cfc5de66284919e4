// environment.glsl - looks up the light of an environment: diffuse by spherical harmonics, specular by
// prefiltered levels and the table of the split sum (firsthit/environment.h).
//
// The including text defines the struct EnvironmentTables and
//
//     vec3 diffuse_term(EnvironmentTables tables, int k)           EnvironmentMap::diffuse()
//     real level_side(EnvironmentTables tables, real level)        EnvironmentMap::sides(), first()
//     real level_first(EnvironmentTables tables, real level)
//     real table_first(EnvironmentTables tables)                   EnvironmentMap::table()
//     real3 weighted_light(EnvironmentTables tables, integer top, integer bottom, FourWeights weights)
//                                                                  of EnvironmentMap::texels()
//     real3 environment_space(EnvironmentTables tables, real3 d)   from world space, by the rotation
//     real environment_strength(EnvironmentTables tables)
//
// source  Cigolle et al. 2014, "A Survey of Efficient Representations for Independent Unit Vectors"
//         (octahedron); Ramamoorthi and Hanrahan 2001; Karis 2013

const int kEnvironmentLevels = 8; // EnvironmentMap::kLevels
const int kTableSide = 32;        // EnvironmentMap::kTableSide

/// Turns a direction about +y, by the angle whose cosine and sine are given, clockwise seen from above.
FIRSTHIT_PURE real3 turned_back(real3 d, float cosine, float sine)
{
    return real3(d.x * cosine - d.z * sine, d.y, d.x * sine + d.z * cosine);
}

FIRSTHIT_PURE real magnitude(real x)
{
    return max(x, 0.0f - x);
}

/// Where a direction lies on the unfolded octahedron, 0 to 1 along both sides: +y in the middle, -y in
/// the corners. Any place for a direction that is 0 or not finite.
FIRSTHIT_PURE real2 octahedral_place(real3 d)
{
    real scale = 1.0f / max(magnitude(d.x) + magnitude(d.y) + magnitude(d.z), 1.0e-30f);
    real x = d.x * scale;
    real z = d.z * scale;
    real folded_x = 1.0f - magnitude(z);
    real folded_z = 1.0f - magnitude(x);
    truth below = d.y < real(0.0f);
    real px = mix(x, mix(folded_x, 0.0f - folded_x, x < real(0.0f)), below);
    real pz = mix(z, mix(folded_z, 0.0f - folded_z, z < real(0.0f)), below);
    return real2(min(max(0.5f * px + 0.5f, 0.0f), 1.0f), min(max(0.5f * pz + 0.5f, 0.0f), 1.0f));
}

/// The four texels around (x, y), weighted. Texel centres are at whole numbers.
///
/// first  index of texel (0, 0)
/// row    texels in a row
FIRSTHIT_PURE real3 weighted_texels(EnvironmentTables tables, real first, real row, real x, real y)
{
    real x0 = floor(x);
    real y0 = floor(y);
    integer top = whole_to_integer(first + (y0 * row + x0));
    integer bottom = top + whole_to_integer(row);
    FourWeights weights;
    weights.bottom_right = (x - x0) * (y - y0);
    weights.bottom_left = (y - y0) - weights.bottom_right;
    weights.top_right = (x - x0) - weights.bottom_right;
    weights.top_left = (1.0f - (x - x0)) - weights.bottom_left;
    return weighted_light(tables, top, bottom, weights);
}

/// The light of a level at a place.
FIRSTHIT_PURE real3 level_light(EnvironmentTables tables, real2 place, real level)
{
    real side = level_side(tables, level);
    // The border's first texel is at 0. The place is in [0.5, side + 0.5].
    return weighted_texels(tables, level_first(tables, level), side + 2.0f, place.x * side + 0.5f,
        place.y * side + 0.5f);
}

/// The light that arrives from a direction of world space.
FIRSTHIT_PURE real3 environment_from(EnvironmentTables tables, real3 d)
{
    return level_light(tables, octahedral_place(environment_space(tables, d)), real(0.0f)) *
           environment_strength(tables);
}

/// What a matt white surface sends to the eye: EnvironmentMap::diffuse().
FIRSTHIT_PURE real3 environment_diffuse(EnvironmentTables tables, real3 n)
{
    real3 sum = all_lanes(diffuse_term(tables, 0)) + all_lanes(diffuse_term(tables, 1)) * n.y +
                all_lanes(diffuse_term(tables, 2)) * n.z +
                all_lanes(diffuse_term(tables, 3)) * n.x +
                all_lanes(diffuse_term(tables, 4)) * (n.x * n.y) +
                all_lanes(diffuse_term(tables, 5)) * (n.y * n.z) +
                all_lanes(diffuse_term(tables, 6)) * (3.0f * n.z * n.z - 1.0f) +
                all_lanes(diffuse_term(tables, 7)) * (n.x * n.z) +
                all_lanes(diffuse_term(tables, 8)) * (n.x * n.x - n.y * n.y);
    return real3(max(sum.x, 0.0f), max(sum.y, 0.0f), max(sum.z, 0.0f));
}

/// What a surface sees of the environment.
///
/// n, to_eye  unit, on the same side of the surface
FIRSTHIT_PURE AroundLight around_light(
    EnvironmentTables tables, real3 n, real3 to_eye, real roughness)
{
    real n_v = min(max(dot(n, to_eye), 0.0f), 1.0f);
    real3 mirrored = n * (2.0f * n_v) - to_eye;
    real2 place = octahedral_place(environment_space(tables, mirrored));
    real at = min(max(roughness, 0.0f), 1.0f) * float(kEnvironmentLevels - 1);
    real level = min(floor(at), float(kEnvironmentLevels - 2));
    real3 smoother = level_light(tables, place, level);
    real3 rougher = level_light(tables, place, level + 1.0f);

    AroundLight around;
    real strength = environment_strength(tables);
    around.diffuse = environment_diffuse(tables, environment_space(tables, n)) * strength;
    around.specular = (smoother + (rougher - smoother) * (at - level)) * strength;
    // The last row and column have weight where the place is just before them.
    real last = real(float(kTableSide - 1) - 0.001f);
    real3 share = weighted_texels(tables, table_first(tables), real(float(kTableSide)),
        min(n_v * float(kTableSide - 1), last),
        min(min(max(roughness, 0.0f), 1.0f) * float(kTableSide - 1), last));
    around.per_f0 = share.x;
    around.per_f90 = share.y;
    return around;
}
