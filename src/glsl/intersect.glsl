// intersect.glsl - tests whether the ray of a sample hits a triangle, and finds the hit.
//
// In eye space (exact/pencil.h): the ray starts at the origin and has the direction d = (X, Y, 1),
// so its depth t is the z of the hit.
//
// source  Olano and Greer 1997, "Triangle Scan Conversion using 2D Homogeneous Coordinates"

struct TriangleHit {
    real t;    // depth; greater than 0 if there is a hit
    real u, v; // weights of corners 1 and 2, in [0, 1]
    truth hit;
};

/// Twice d . (a x b), computed as d . ((a + b) x (b - a)): this keeps the digits of a short edge
/// far from the origin, which the plain cross product would lose. Swapping a and b negates the
/// result exactly, so a ray through the common edge of two triangles hits at least one of them.
FIRSTHIT_PURE real edge_volume(real3 a, real3 b, real3 d)
{
    FIRSTHIT_PRECISE real3 sum = a + b;
    FIRSTHIT_PRECISE real3 edge = b - a;
    FIRSTHIT_PRECISE real x = (sum.y * edge.z - sum.z * edge.y) * d.x;
    FIRSTHIT_PRECISE real y = (sum.z * edge.x - sum.x * edge.z) * d.y;
    FIRSTHIT_PRECISE real z = (sum.x * edge.y - sum.y * edge.x) * d.z;
    FIRSTHIT_PRECISE real volume = (x + y) + z;
    return volume;
}

/// x clamped to [low, high]; `low` for NaN.
FIRSTHIT_PURE real between(real x, real low, real high)
{
    real above = mix(low, x, x > low);
    return mix(high, above, above < high);
}

/// A ray through an edge hits both triangles of the edge. If `hit` is false only because of
/// rounding, t, u and v still belong to a point of the triangle.
///
/// limits  edges are accurate to about 1e-4 samples, and less so if they run along the ray, because
///         the rounding error grows with the length of the edge. Coordinates must be below 1e12
FIRSTHIT_PURE TriangleHit intersect(real3 a, real3 b, real3 c, real3 d)
{
    real weight_a = edge_volume(b, c, d);
    real weight_b = edge_volume(c, a, d);
    real weight_c = edge_volume(a, b, d);
    real least = min(weight_a, min(weight_b, weight_c));
    real greatest = max(weight_a, max(weight_b, weight_c));

    // Inside, all weights have the same sign: the least is not below 0, or the greatest not above.
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
