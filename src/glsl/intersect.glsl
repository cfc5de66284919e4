// intersect.glsl - does the ray of a sample hit a triangle, and where?
//
// In the space of exact/pencil.h: the ray starts at the origin, along d = (X, Y, 1), and its depth t
// is the z of the hit.
//
// source  Olano and Greer 1997, "Triangle Scan Conversion using 2D Homogeneous Coordinates"

struct TriangleHit {
    real t;    // depth; above 0 where there is a hit
    real u, v; // weights of corners 1 and 2, in [0, 1]
    truth hit;
};

/// Twice d . (a x b), as d . ((a + b) x (b - a)): a small edge far out keeps its digits, which the
/// plain cross product loses. Exactly the opposite number where a and b change places, so of two
/// triangles that share an edge at least one has the ray.
FIRSTHIT_PURE real edge_volume(real3 a, real3 b, real3 d)
{
    FIRSTHIT_PRECISE real3 sum = a + b;
    FIRSTHIT_PRECISE real3 way = b - a;
    FIRSTHIT_PRECISE real x = (sum.y * way.z - sum.z * way.y) * d.x;
    FIRSTHIT_PRECISE real y = (sum.z * way.x - sum.x * way.z) * d.y;
    FIRSTHIT_PRECISE real z = (sum.x * way.y - sum.y * way.x) * d.z;
    FIRSTHIT_PRECISE real volume = (x + y) + z;
    return volume;
}

/// x moved into [low, high]; low where it is no number.
FIRSTHIT_PURE real between(real x, real low, real high)
{
    real above = mix(low, x, x > low);
    return mix(high, above, above < high);
}

/// Borders belong to both of their triangles. Where `hit` is false for a rounding's sake, t, u and v
/// are still those of a point of the triangle.
///
/// limits  edges are right to about 1e-4 samples, less where they run along the ray: float's
///         roundings grow with the edge's length in space; corners below 1e12
FIRSTHIT_PURE TriangleHit intersect(real3 a, real3 b, real3 c, real3 d)
{
    real weight_a = edge_volume(b, c, d);
    real weight_b = edge_volume(c, a, d);
    real weight_c = edge_volume(a, b, d);
    real least = min(weight_a, min(weight_b, weight_c));
    real greatest = max(weight_a, max(weight_b, weight_c));

    // All weights have one sign: the least is not below 0, or the greatest not above.
    real inside = max(least, 0.0f - greatest);
    real inv_sum = 1.0f / ((weight_a + weight_b) + weight_c);
    real t = (weight_a * a.z + weight_b * b.z + weight_c * c.z) * inv_sum;

    TriangleHit result;
    result.hit = mix(real(-1.0f), inside, t > real(0.0f)) >= real(0.0f);
    result.t = between(t, min(a.z, min(b.z, c.z)), max(a.z, max(b.z, c.z)));
    result.u = between(weight_b * inv_sum, real(0.0f), real(1.0f));
    result.v = between(weight_c * inv_sum, real(0.0f), real(1.0f));
    return result;
}
