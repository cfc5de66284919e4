// certify.geom - makes a polygon that contains all samples whose rays may hit the triangle: see
// gl/items/certified_items.h.
//
// The picture is clipped by the three planes through the eye and an edge of the triangle, each
// moved outwards. This projects no corners, so a triangle that reaches behind the eye is no special
// case (Olano and Greer 1997). A triangle in front of the eye is first restricted to the box of its
// projected corners.

layout(triangles) in;
layout(triangle_strip, max_vertices = 7) out;

in vec3 corner[];

flat out vec3 corner_a;
flat out vec3 corner_b;
flat out vec3 corner_c;
flat out uint triangle;

uniform vec2 first;  // direction of the first sample
uniform vec2 last;   // direction of the last sample
uniform vec2 scale;  // clip = scale * direction + shift, see SampleToClip
uniform vec2 shift;

// How far the planes are moved outwards, in samples. More than the rasteriser's grid (1/256) and
// the rounding errors on the way to it.
const float kOutset = 1.0 / 16.0;
const float kRounding = 1.0 / 4194304.0; // 2^-22: a few rounding errors
const float kFlushed = 1e-36;            // far above the largest number that drivers flush to 0

const int kMost = 7;
vec2 polygon[kMost];
int count;

void cut(vec3 n, vec3 error, float side)
{
    float size = max(abs(n.x), max(abs(n.y), abs(n.z)));
    if (!(size > 1e-30)) return; // the plane is mostly rounding error: do not clip
    n /= size;
    error /= size;
    // Inside is side * n . (x, y, 1) >= -room. `room` covers the error of n.
    vec2 farthest = max(abs(first), abs(last)) + 1.0;
    float room = kOutset * (abs(n.x) + abs(n.y)) + dot(error, vec3(farthest, 1.0)) +
                 4.0 * kRounding * (abs(n.x) * farthest.x + abs(n.y) * farthest.y + abs(n.z));
    vec2 kept[kMost];
    int number = 0;
    for (int k = 0; k < count; ++k) {
        vec2 p = polygon[k], q = polygon[k + 1 < count ? k + 1 : 0];
        float at_p = side * dot(n, vec3(p, 1.0)) + room;
        float at_q = side * dot(n, vec3(q, 1.0)) + room;
        if (at_p >= 0.0 && number < kMost) kept[number++] = p;
        if ((at_p >= 0.0) != (at_q >= 0.0) && number < kMost)
            kept[number++] = mix(p, q, clamp(at_p / (at_p - at_q), 0.0, 1.0));
    }
    for (int k = 0; k < number; ++k) polygon[k] = kept[k];
    count = number;
}

/// The largest absolute coordinate.
float reach(vec3 p)
{
    return max(abs(p.x), max(abs(p.y), abs(p.z)));
}

/// The power of two by which a reach from 1e-20 to 1e30 becomes a number in [1, 2).
float scale_of(float reached)
{
    return uintBitsToFloat((254u - (floatBitsToUint(reached) >> 23)) << 23);
}

/// The direction of a x b, computed as (a + b) x (b - a), and a bound of its rounding error. a and
/// b are scaled first, so that products do not overflow and the effect of flushing to 0 is bounded.
vec3 edge_plane(vec3 a, vec3 b, out vec3 error)
{
    float to_one = scale_of(max(reach(a), reach(b)));
    a *= to_one;
    b *= to_one;
    vec3 sum = a + b, edge = b - a;
    vec3 left = sum.yzx * edge.zxy, right = sum.zxy * edge.yzx;
    error = kRounding * (abs(left) + abs(right)) + kFlushed * (to_one + 1.0);
    return left - right;
}

void emit(vec2 p, vec3 a, vec3 b, vec3 c)
{
    corner_a = a;
    corner_b = b;
    corner_c = c;
    triangle = uint(gl_PrimitiveIDIn);
    gl_Position = vec4(p * scale + shift, 0.0, 1.0);
    EmitVertex();
}

void main()
{
    vec3 a = corner[0], b = corner[1], c = corner[2];
    float reach_a = reach(a), reach_b = reach(b), reach_c = reach(c);
    // Such triangles are invisible: kFarthest in exact/hit.h.
    if (!(reach_a < 1e30 && reach_b < 1e30 && reach_c < 1e30)) return;
    float nearest_z = min(a.z, min(b.z, c.z));
    if (max(a.z, max(b.z, c.z)) < 0.0) return;

    vec2 low = first - 1.0, high = last + 1.0;
    if (nearest_z > 1e-30) {
        vec2 pa = a.xy / a.z, pb = b.xy / b.z, pc = c.xy / c.z;
        vec2 least = min(pa, min(pb, pc)), most = max(pa, max(pb, pc));
        low = max(low, least - (kOutset + 4.0 * kRounding * abs(least)));
        high = min(high, most + (kOutset + 4.0 * kRounding * abs(most)));
        if (low.x > high.x || low.y > high.y) return;
    }
    polygon[0] = low;
    polygon[1] = vec2(high.x, low.y);
    polygon[2] = high;
    polygon[3] = vec2(low.x, high.y);
    count = 4;

    // Testing a few samples is faster than clipping. Very small triangles are not clipped either.
    if ((high.x - low.x) * (high.y - low.y) > 9.0 && min(reach_a, min(reach_b, reach_c)) > 1e-20) {
        vec3 error_ab, error_bc, error_ca;
        vec3 ab = edge_plane(a, b, error_ab), bc = edge_plane(b, c, error_bc),
             ca = edge_plane(c, a, error_ca);
        // Clip only if the sign of the volume is certain.
        float to_one = scale_of(reach_c);
        vec3 far = c * to_one;
        float volume = dot(ab, far);
        float error = dot(error_ab, abs(far)) + 4.0 * kRounding * dot(abs(ab), abs(far)) +
                      kFlushed * (to_one + 1.0);
        if (abs(volume) > 2.0 * error) {
            float side = sign(volume);
            cut(ab, error_ab, side);
            cut(bc, error_bc, side);
            cut(ca, error_ca, side);
            if (count < 3) return;
        }
    }
    // Emit the convex polygon as a strip that zigzags from one end to the other.
    for (int k = 0; k < count; ++k) {
        int at = (k & 1) == 0 ? k / 2 : count - 1 - k / 2;
        emit(polygon[at], a, b, c);
    }
    EndPrimitive();
}
