// certify.geom - a polygon that holds all samples that the triangle may hit: see
// gl/items/certified_items.h.
//
// The polygon is cut out of the picture by the triangle's three planes through the eye, each moved
// outwards. No corner is projected for it, so a triangle that reaches behind the eye is no special
// case (Olano and Greer 1997); in front of the eye the corners' box is cut first.

layout(triangles) in;
layout(triangle_strip, max_vertices = 7) out;

in vec3 corner[];

flat out vec3 corner_a;
flat out vec3 corner_b;
flat out vec3 corner_c;
flat out uint triangle;

uniform vec2 first;  // direction of the first sample
uniform vec2 last;   // of the last
uniform vec2 scale;  // of directions, to -1 .. 1
uniform vec2 shift;

// Samples: more than the rasteriser's steps (1/256) and what is rounded on the way to them.
const float kOutset = 1.0 / 16.0;
const float kRounding = 1.0 / 4194304.0; // 2^-22: a few roundings
const float kFlushed = 1e-36;            // more than drivers make 0, many times

const int kMost = 7;
vec2 polygon[kMost];
int count;

void cut(vec3 n, vec3 error, float side)
{
    float size = max(abs(n.x), max(abs(n.y), abs(n.z)));
    if (!(size > 1e-30)) return; // nothing is cut off by what is mostly rounding
    n /= size;
    error /= size;
    // Inside: side * n . (x, y, 1) >= -room, for all that the rounded n might mean.
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

/// Greatest coordinate of any axis.
float reach(vec3 p)
{
    return max(abs(p.x), max(abs(p.y), abs(p.z)));
}

/// The power of two that takes a reach of 1e-20 to 1e30 to [1, 2).
float scale_of(float reached)
{
    return uintBitsToFloat((254u - (floatBitsToUint(reached) >> 23)) << 23);
}

/// The direction of a x b, as (a + b) x (b - a), and how far rounding may have moved it. Scaled
/// before, so that nothing overflows, and what is flushed to 0 is known.
vec3 edge_plane(vec3 a, vec3 b, out vec3 error)
{
    float to_one = scale_of(max(reach(a), reach(b)));
    a *= to_one;
    b *= to_one;
    vec3 sum = a + b, way = b - a;
    vec3 left = sum.yzx * way.zxy, right = sum.zxy * way.yzx;
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
    // No triangle: kFarthest in exact/hit.h.
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

    // A few samples are sooner asked than cut; what is too small is not cut either.
    if ((high.x - low.x) * (high.y - low.y) > 9.0 && min(reach_a, min(reach_b, reach_c)) > 1e-20) {
        vec3 error_ab, error_bc, error_ca;
        vec3 ab = edge_plane(a, b, error_ab), bc = edge_plane(b, c, error_bc),
             ca = edge_plane(c, a, error_ca);
        // Without a certain side nothing is cut off.
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
    // A strip, from one end of the polygon to the other.
    for (int k = 0; k < count; ++k) {
        int at = (k & 1) == 0 ? k / 2 : count - 1 - k / 2;
        emit(polygon[at], a, b, c);
    }
    EndPrimitive();
}
