// pose.comp - computes the position of every vertex at the frame's time: see
// gl/scene/scene_buffers.h.
//
// SURFACES 1: writes world positions and normals as well as positions in eye space.

layout(local_size_x = 64) in;

#include "gl/bindings.glsl"
#include "gl/pose_layout.glsl"

layout(std430, binding = kPoseMatricesBlock) readonly buffer Matrices { MatrixData matrix[]; };
layout(std430, binding = kPoseInstancesBlock) readonly buffer Instances { InstanceData instance[]; };
layout(std430, binding = kPoseInstanceOfVertexBlock) readonly buffer InstanceOf { uint instance_of[]; };
layout(std430, binding = kPoseRestPositionsBlock) readonly buffer RestPosition { float rest_position[]; };
layout(std430, binding = kPoseMovingPositionsBlock) readonly buffer MovingPosition { float moving_position[]; };
layout(std430, binding = kPoseEyeBlock) writeonly buffer Eye { vec4 eye[]; };
#if SURFACES
layout(std430, binding = kPoseRestNormalsBlock) readonly buffer RestNormal { float rest_normal[]; };
layout(std430, binding = kPoseMovingNormalsBlock) readonly buffer MovingNormal { float moving_normal[]; };
layout(std430, binding = kPoseWorldBlock) writeonly buffer World { vec4 world[]; };
layout(std430, binding = kPoseNormalsBlock) writeonly buffer Normal { vec4 normal[]; };
#endif

uniform uint vertices;
uniform dvec3 eye_point;
uniform dvec3 eye_row[3]; // of eye_from_world

void main()
{
    // Groups are dispatched in rows, because one row may be too short for all vertices.
    uint vertex = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x
        + gl_LocalInvocationID.x;
    if (vertex >= vertices) return;
    InstanceData from = instance[instance_of[vertex]];
    uint at = 3u * (from.moving != 0u ? from.first + (vertex - from.first_vertex) : vertex);
    vec3 p;
    if (from.moving != 0u)
        p = vec3(moving_position[at], moving_position[at + 1u], moving_position[at + 2u]);
    else
        p = vec3(rest_position[at], rest_position[at + 1u], rest_position[at + 2u]);
    uint m = from.matrix;
    // The operations have the order of scene/animate/pose_kernel.cpp, then of
    // visibility/bin/project.cpp, so that the results have the same bits.
    precise vec3 p_world;
    for (int row = 0; row < 3; ++row) {
        vec4 w = matrix[m].world[row];
        p_world[row] = ((w.x * p.x + w.y * p.y) + w.z * p.z) + w.w;
    }
    if (from.moving != 0u) p_world = p; // is in world space already
    precise dvec3 d = dvec3(p_world) - eye_point;
    precise vec3 p_eye;
    for (int row = 0; row < 3; ++row)
        p_eye[row] = float((eye_row[row].x * d.x + eye_row[row].y * d.y) + eye_row[row].z * d.z);
    eye[vertex] = vec4(p_eye, 1.0);

#if SURFACES
    world[vertex] = vec4(p_world, 1.0);
    if (from.moving != 0u) {
        normal[vertex] =
            vec4(moving_normal[at], moving_normal[at + 1u], moving_normal[at + 2u], 0.0);
        return;
    }
    vec3 n = vec3(rest_normal[at], rest_normal[at + 1u], rest_normal[at + 2u]);
    vec3 moved = vec3(dot(matrix[m].normal[0].xyz, n), dot(matrix[m].normal[1].xyz, n),
        dot(matrix[m].normal[2].xyz, n));
    float length2 = dot(moved, moved);
    bool has_direction = length2 >= 1e-30 && length2 <= 3.4e38; // the length is about 1
    normal[vertex] = vec4(has_direction ? moved / sqrt(length2) : vec3(0.0, 0.0, 1.0), 0.0);
#endif
}
