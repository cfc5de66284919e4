// hit_bounds.comp - the part of each light's projection that visible hits fill: the rectangles of
// src/shadow/hit_bounds.h. A group is a block of 8 x 8 samples.
#include "frame.glsl"
#include "scene.glsl"
#include "intersect.glsl"
#include "items.glsl"
#include "find_hit.glsl"
#include "lights.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

/// (lights, 6 faces): least x and y, as the greatest of their opposite; greatest x and y; hits.
const int kNumbers = 5;
layout(std430, binding = 0) buffer Bounds { uint bounds[]; };

shared uint block_bounds[kFaces * kNumbers];
shared uint block_hits, block_nearest, block_farthest;
shared uint corners_on[kFaces], corners_reached;

/// Ordered as the floats are, above 0: so 0 is below all of them.
uint key_of(float x)
{
    uint bits = floatBitsToUint(x);
    return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}

bool has_shadow_ray(vec3 p, bool parallel)
{
    vec3 size = abs(p);
    float largest = max(size.x, max(size.y, size.z));
    return largest < 1e30 && (parallel || largest > 0.0);
}

void add_point(LightData light, int face, vec3 p)
{
    vec2 at = p.xy;
    if (light.kind != kDirectionalLight) {
        int axis = face / 2;
        float inv_z = (face % 2 == 1 ? -1.0 : 1.0) / p[axis];
        at = vec2(p[(axis + 1) % 3] * inv_z, p[(axis + 2) % 3] * inv_z);
    }
    atomicMax(block_bounds[face * kNumbers], ~key_of(at.x));
    atomicMax(block_bounds[face * kNumbers + 1], ~key_of(at.y));
    atomicMax(block_bounds[face * kNumbers + 2], key_of(at.x));
    atomicMax(block_bounds[face * kNumbers + 3], key_of(at.y));
}

int face_of(LightData light, vec3 p)
{
    return light.cube != 0 ? face_of(p) : 4;
}

void add_light(int id, LightData light, bool is_seen, vec3 eye_d, float t)
{
    int thread = int(gl_LocalInvocationIndex);
    bool parallel = light.kind == kDirectionalLight;
    for (int k = thread; k < kFaces * kNumbers; k += 64) block_bounds[k] = 0u;
    if (thread < kFaces) corners_on[thread] = 0u;
    if (thread == 0) corners_reached = 0u;
    barrier();

    // The hits lie in the hull of the block's four corner rays at its nearest and at its farthest
    // depth. Where all eight points are on one face, they bound it.
    vec3 corner = vec3(0.0);
    bool reached = false;
    if (thread < 8) {
        ivec2 first = ivec2(gl_WorkGroupID.xy) * 8;
        vec3 d = eye_direction(first + 7 * ivec2(thread & 1, thread >> 1 & 1));
        corner = transform_ray(
            light.to_frame, d, uintBitsToFloat(thread < 4 ? block_nearest : block_farthest));
        reached = has_shadow_ray(corner, parallel);
        if (reached) atomicAdd(corners_reached, 1u);
        atomicAdd(corners_on[face_of(light, corner)], 1u);
    }
    barrier();
    bool as_hull = light.tan2_cone == 0.0 && corners_reached == 8u;
    int hull_face = -1;
    for (int face = 0; face < kFaces; ++face)
        if (corners_on[face] == 8u) hull_face = face;
    if (as_hull && hull_face >= 0) {
        if (thread < 8) add_point(light, hull_face, corner);
        if (thread == 0) block_bounds[hull_face * kNumbers + 4] = block_hits;
    } else if (is_seen) {
        vec3 p = transform_ray(light.to_frame, eye_d, t);
        bool counts = has_shadow_ray(p, parallel);
        if (light.tan2_cone > 0.0) counts = counts && in_cone(p, light.tan2_cone);
        if (counts) {
            int face = face_of(light, p);
            add_point(light, face, p);
            atomicAdd(block_bounds[face * kNumbers + 4], 1u);
        }
    }
    barrier();

    for (int k = thread; k < kFaces * kNumbers; k += 64) {
        uint value = block_bounds[k];
        int to = id * kFaces * kNumbers + k;
        if (value == 0u) continue;
        if (k % kNumbers == 4)
            atomicAdd(bounds[to], value);
        else if (value > bounds[to]) // mostly it is not
            atomicMax(bounds[to], value);
    }
    barrier();
}

void main()
{
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    bool is_seen = false;
    Hit hit = Hit(kNoItem, 0.0, 0.0, 0.0);
    if (all(lessThan(at, frame.size))) {
        hit = find_hit(at);
        is_seen = is_hit(hit);
    }
    if (gl_LocalInvocationIndex == 0u) {
        block_hits = 0u;
        block_nearest = 0x7F800000u;
        block_farthest = 0u;
    }
    barrier();
    if (is_seen) {
        atomicAdd(block_hits, 1u);
        atomicMin(block_nearest, floatBitsToUint(hit.t));
        atomicMax(block_farthest, floatBitsToUint(hit.t));
    }
    barrier();
    bool is_empty = block_hits == 0u;
    if (is_empty) return;
    for (int id = 0; id < frame.lights; ++id)
        add_light(id, light_data[id], is_seen, eye_direction(at), hit.t);
}
