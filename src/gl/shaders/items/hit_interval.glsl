// hit_interval.glsl - what float can say for sure of a ray and a triangle.
//
// The corners are taken as exact, as in exact/hit.h; so is the ray (x, y, 1). Every error is bounded
// from above: kUnit is four times what one rounding of a float may be, and fused operations, which
// GLSL allows, have fewer roundings.
//
//     A = a.xy - (x, y) a.z                  a corner beside the ray, |error| <= A_error
//     edge(a, b, d) = A.x B.y - A.y B.x      (Woop et al. 2013), error by the product rule
//     t = (e_bc a.z + e_ca b.z + e_ab c.z) / (e_bc + e_ca + e_ab)
//
// If the edges' errors are E_k, t is off by at most sum(E_k) (greatest z - least z) / (|sum(e_k)| -
// sum(E_k)); and a hit lies between the least and the greatest z.

const float kUnit = 1.0 / 4194304.0; // 2^-22
const float kTiny = 1e-36;           // what is below may be flushed to 0

struct HitInterval {
    bool perhaps;       // false: certainly no hit
    bool surely;        // a hit
    float least, most;  // if there is a hit, its t is in [least, most]
};

struct Corner {
    vec2 at, error;
};

Corner beside_ray(vec3 p, vec2 ray)
{
    vec2 shift = ray * p.z;
    Corner corner;
    corner.at = p.xy - shift;
    corner.error = kUnit * (abs(p.xy) + abs(shift)) + kTiny * (abs(ray) + 1.0);
    return corner;
}

/// x: the edge, y: how far it may be off.
vec2 edge_between(Corner a, Corner b)
{
    float left = a.at.x * b.at.y, right = a.at.y * b.at.x;
    vec2 size_a = abs(a.at) + a.error, size_b = abs(b.at) + b.error;
    float error = size_a.x * b.error.y + size_b.y * a.error.x + size_a.y * b.error.x +
                  size_b.x * a.error.y + kUnit * (abs(left) + abs(right));
    return vec2(left - right, error * 1.01 + kTiny);
}

/// 1, -1, or 0 where it is not certain; what overflows is not.
int certain_sign(vec2 edge)
{
    return edge.x > edge.y ? 1 : edge.x < -edge.y ? -1 : 0;
}

HitInterval hit_interval(vec3 a, vec3 b, vec3 c, vec2 ray)
{
    Corner at_a = beside_ray(a, ray), at_b = beside_ray(b, ray), at_c = beside_ray(c, ray);
    vec2 ab = edge_between(at_a, at_b), bc = edge_between(at_b, at_c),
         ca = edge_between(at_c, at_a);
    int sign_ab = certain_sign(ab), sign_bc = certain_sign(bc), sign_ca = certain_sign(ca);
    int greatest = max(sign_ab, max(sign_bc, sign_ca)),
        least = min(sign_ab, min(sign_bc, sign_ca));

    HitInterval hit;
    hit.least = min(a.z, min(b.z, c.z));
    hit.most = max(a.z, max(b.z, c.z));
    hit.perhaps = !(greatest == 1 && least == -1) && hit.most >= 0.0;
    hit.surely = false;
    if (greatest == least && greatest != 0) {
        float sum = abs((ab.x + bc.x) + ca.x), error = ((ab.y + bc.y) + ca.y) * 1.01;
        // Quotients first: products of edges or errors and depths might underflow.
        float t = abs(bc.x) / sum * a.z + abs(ca.x) / sum * b.z + abs(ab.x) / sum * c.z;
        float off = error / (sum - error) * (hit.most - hit.least) +
                    8.0 * kUnit * max(abs(hit.least), abs(hit.most)) + kTiny;
        off *= 1.01;
        // What overflows or is no number changes nothing.
        if (sum > 2.0 * error && sum < 1e37) {
            if (t - off > hit.least) hit.least = t - off;
            if (t + off < hit.most) hit.most = t + off;
        }
        if (hit.most < 0.0) hit.perhaps = false;
        hit.surely = hit.perhaps && hit.least > 0.0;
    }
    return hit;
}
