// find_hit.glsl - finds the triangle that the ray of a sample hits, and the hit.
//
// source  Robert and Schoepke 2006, sections 4.1 (lazy multisampling) and 4.2.1

const uint kHole = kNoItem - 1u; // there is an item, but no triangle that is hit; or not shot

// FIRSTHIT_TEST: what is done if the ray misses the triangle of its item; see HitTest. These are
// variants of the shader and not branches, because drivers that run many samples together execute
// both sides of a branch.
#define TAKE_ITEM 0 // the items are exact: nothing is missed
#define TEST_ITEM 1 // a hole
#define TRY_NEIGHBOURS 2 // the nearest hit among the items around
#define TRY_ALL 3 // the same, also where the first test succeeds

struct Hit {
    uint item;
    float t; // depth, world units
    float u, v; // weights of corners 1 and 2
};

bool is_hit(Hit hit)
{
    return hit.item < kHole;
}

#ifdef FIRSTHIT_STORED_HITS

layout(binding = kHitsUnit) uniform usampler2D hits;

Hit find_hit(ivec2 sample_at)
{
    uvec4 stored = texelFetch(hits, sample_at, 0);
    return Hit(stored.x, uintBitsToFloat(stored.y), uintBitsToFloat(stored.z),
        uintBitsToFloat(stored.w));
}

#else

TriangleHit test_triangle(uint triangle, vec3 d)
{
    uvec3 corner = triangle_corners(triangle);
    return intersect(
        eye_position(corner.x), eye_position(corner.y), eye_position(corner.z), d);
}

#if FIRSTHIT_TEST == TRY_NEIGHBOURS || FIRSTHIT_TEST == TRY_ALL
/// The nearest hit among the items around the sample; the lowest id among hits at the same depth.
/// otherwise  the result if the ray hits none of them
Hit nearest_around(ivec2 sample_at, vec3 d, Hit otherwise)
{
    Hit nearest = otherwise;
    float least = uintBitsToFloat(0x7F800000u);
    uint tried = kNoItem;
    for (int y = -frame.reach; y <= frame.reach; ++y) {
        for (int x = -frame.reach; x <= frame.reach; ++x) {
            ivec2 at = sample_at + ivec2(x, y);
            if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, frame.size))) continue;
            uint item = item_at(at);
            if (item == tried || item >= frame.triangles) continue;
            tried = item;
            TriangleHit found = test_triangle(item, d);
            if (!found.hit || found.t > least || (found.t == least && item > nearest.item))
                continue;
            least = found.t;
            nearest = Hit(item, found.t, found.u, found.v);
        }
    }
    return nearest;
}
#endif

Hit find_hit(ivec2 sample_at)
{
    const Hit hole = Hit(kHole, 0.0, 0.0, 0.0);
    if (!is_shot(sample_at)) return hole;
    uint item = item_at(sample_at);
    vec3 d = eye_direction(sample_at);
    Hit otherwise = hole;
    if (item == kNoItem) otherwise.item = kNoItem;
#if FIRSTHIT_TEST == TRY_ALL
    return nearest_around(sample_at, d, otherwise);
#else
    if (item == kNoItem) return otherwise;
    if (item < frame.triangles) {
        TriangleHit found = test_triangle(item, d);
        if (found.hit || FIRSTHIT_TEST == TAKE_ITEM) return Hit(item, found.t, found.u, found.v);
    }
#if FIRSTHIT_TEST == TRY_NEIGHBOURS
    return nearest_around(sample_at, d, hole);
#else
    return hole;
#endif
#endif
}

#endif
