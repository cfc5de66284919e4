// hit_bounds.comp - finds the bounds of the visible hits on the faces of each light, as
// shadow/map/hit_bounds.h. Each invocation handles a block of 8 x 8 samples.
#include "frame.glsl"
#include "scene.glsl"
#include "intersect.glsl"
#include "items.glsl"
#include "find_hit.glsl"
#include "lights.glsl"

layout(local_size_x = 32) in;

/// (lights, kFaces, kNumbers): complements of the keys of the least x and y, so that all are
/// maxima; keys of the greatest x and y; number of hits.
const int kNumbers = 5;
layout(std430, binding = kResultBlock) coherent buffer Bounds { uint bounds[]; };

/// An integer for each float, in the same order. 0 is less than the key of any number.
uint key_of(float x)
{
    uint bits = floatBitsToUint(x);
    return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}

void raise(int at, uint key)
{
    if (key > bounds[at]) atomicMax(bounds[at], key); // usually it is not greater
}

void add_rectangle(int light_id, int face, vec2 low, vec2 high, uint hits)
{
    int first = (light_id * kFaces + face) * kNumbers;
    raise(first, ~key_of(low.x));
    raise(first + 1, ~key_of(low.y));
    raise(first + 2, key_of(high.x));
    raise(first + 3, key_of(high.y));
    atomicAdd(bounds[first + 4], hits);
}

bool has_shadow_ray(vec3 p, bool parallel)
{
    vec3 size = abs(p);
    float largest = max(size.x, max(size.y, size.z));
    return largest < 1e30 && (parallel || largest > 0.0);
}

int face_of(LightData light, vec3 p)
{
    return light.cube != 0 ? face_of(p) : 4;
}

/// The projection of a point onto a face.
vec2 on_face(LightData light, int face, vec3 p)
{
    if (light.kind == kDirectionalLight) return p.xy;
    vec3 turned = face / 2 == 0 ? p.yzx : face / 2 == 1 ? p.zxy : p.xyz;
    return turned.xy * ((face % 2 == 1 ? -1.0 : 1.0) / turned.z);
}

struct Block {
    ivec2 first; // its first sample
    float nearest, farthest; // depths of its hits
    uint hits;
};

/// The hits lie in the convex hull of eight points: the block's four corner rays at its nearest and
/// at its farthest depth. If these points all lie on one face, adds them as bounds of the hits.
/// Otherwise adds nothing and returns false.
bool add_hull(int light_id, LightData light, Block block)
{
    bool parallel = light.kind == kDirectionalLight;
    vec2 low = vec2(uintBitsToFloat(0x7F800000u)), high = -low;
    int shared_face = -1;
    bool one_face = light.tan2_cone == 0.0;
    for (int k = 0; k < 8; ++k) {
        vec3 d = eye_direction(block.first + 7 * ivec2(k & 1, k >> 1 & 1));
        vec3 p = transform_ray(light.to_frame, d, k < 4 ? block.nearest : block.farthest);
        int face = face_of(light, p);
        if (k == 0) shared_face = face;
        one_face = one_face && face == shared_face && has_shadow_ray(p, parallel);
        vec2 at = on_face(light, face, p);
        low = min(low, at);
        high = max(high, at);
    }
    if (one_face) add_rectangle(light_id, shared_face, low, high, block.hits);
    return one_face;
}

void add_hits(int light_id, LightData light, Block block)
{
    bool parallel = light.kind == kDirectionalLight;
    for (int k = 0; k < 64; ++k) {
        ivec2 at = block.first + ivec2(k & 7, k >> 3);
        if (any(greaterThanEqual(at, frame.size))) continue;
        Hit hit = find_hit(at);
        if (!is_hit(hit)) continue;
        vec3 p = transform_ray(light.to_frame, eye_direction(at), hit.t);
        if (!has_shadow_ray(p, parallel)) continue;
        if (light.tan2_cone > 0.0 && !in_cone(p, light.tan2_cone)) continue;
        int face = face_of(light, p);
        vec2 seen = on_face(light, face, p);
        add_rectangle(light_id, face, seen, seen, 1u);
    }
}

void main()
{
    ivec2 blocks = (frame.size + 7) / 8;
    int number = int(gl_GlobalInvocationID.x);
    if (number >= blocks.x * blocks.y) return;
    Block block = Block(
        8 * ivec2(number % blocks.x, number / blocks.x), uintBitsToFloat(0x7F800000u), 0.0, 0u);
    for (int k = 0; k < 64; ++k) {
        ivec2 at = block.first + ivec2(k & 7, k >> 3);
        if (any(greaterThanEqual(at, frame.size))) continue;
        Hit hit = find_hit(at);
        if (!is_hit(hit)) continue;
        block.nearest = min(block.nearest, hit.t);
        block.farthest = max(block.farthest, hit.t);
        ++block.hits;
    }
    if (block.hits == 0u) return;
    for (int id = 0; id < frame.lights; ++id)
        if (!add_hull(id, light_data[id], block)) add_hits(id, light_data[id], block);
}
