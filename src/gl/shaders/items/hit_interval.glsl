// hit_interval.glsl - tests a ray against a triangle in float with bounds of all errors.
//
// The corners and the ray (x, y, 1) are taken as exact, as in exact/hit.h. All error bounds are
// upper bounds: kUnit is four times the largest relative rounding error of float. GLSL allows fused
// operations; these round less often.
//
//     A = a.xy - (x, y) a.z                  a corner relative to the ray, |error| <= A_error
//     edge(a, b, d) = A.x B.y - A.y B.x      (Woop et al. 2013), error by the product rule
//     t = (e_bc a.z + e_ca b.z + e_ab c.z) / (e_bc + e_ca + e_ab)
//
// If the errors of the edges are at most E_k, the error of t is at most
// sum(E_k) (greatest z - least z) / (|sum(e_k)| - sum(E_k)). A hit also lies between the least and
// the greatest z.

const float kUnit = 1.0 / 4194304.0; // 2^-22
const float kTiny = 1e-36;           // drivers may flush smaller numbers to 0

struct HitInterval {
    bool perhaps;       // false: certainly no hit
    bool surely;        // true: certainly a hit
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

/// x: the value of the edge function, y: bound of its error.
vec2 edge_between(Corner a, Corner b)
{
    float left = a.at.x * b.at.y, right = a.at.y * b.at.x;
    vec2 size_a = abs(a.at) + a.error, size_b = abs(b.at) + b.error;
    float error = size_a.x * b.error.y + size_b.y * a.error.x + size_a.y * b.error.x +
                  size_b.x * a.error.y + kUnit * (abs(left) + abs(right));
    return vec2(left - right, error * 1.01 + kTiny);
}

/// The sign of an edge, 1 or -1; 0 if it is not certain, also after an overflow.
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
        // Divide first, because products of edges or errors with depths could underflow.
        float t = abs(bc.x) / sum * a.z + abs(ca.x) / sum * b.z + abs(ab.x) / sum * c.z;
        float off = error / (sum - error) * (hit.most - hit.least) +
                    8.0 * kUnit * max(abs(hit.least), abs(hit.most)) + kTiny;
        off *= 1.01;
        // After an overflow, and for NaN, the bounds stay as they are.
        if (sum > 2.0 * error && sum < 1e37) {
            if (t - off > hit.least) hit.least = t - off;
            if (t + off < hit.most) hit.most = t + off;
        }
        if (hit.most < 0.0) hit.perhaps = false;
        hit.surely = hit.perhaps && hit.least > 0.0;
    }
    return hit;
}
