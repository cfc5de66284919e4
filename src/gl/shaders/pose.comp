// pose.comp - moves every vertex to where it is at the frame's time: see gl/scene/scene_buffers.h.
//
// SURFACES 1: world positions and normals too, not eye space alone.

layout(local_size_x = 64) in;

struct MatrixData {
    vec4 world[3];
    vec4 normal[3];
};

struct PartData {
    uint matrix;
    uint moving;
    uint first;
    uint first_vertex;
    uint vertex_count;
    uint material;
};

layout(std430, binding = 0) readonly buffer Matrices { MatrixData matrix[]; };
layout(std430, binding = 1) readonly buffer Parts { PartData part[]; };
layout(std430, binding = 2) readonly buffer PartOf { uint part_of[]; };
layout(std430, binding = 3) readonly buffer RestPosition { float rest_position[]; };
layout(std430, binding = 4) readonly buffer MovingPosition { float moving_position[]; };
layout(std430, binding = 5) writeonly buffer Eye { vec4 eye[]; };
#if SURFACES
layout(std430, binding = 6) readonly buffer RestNormal { float rest_normal[]; };
layout(std430, binding = 7) readonly buffer MovingNormal { float moving_normal[]; };
layout(std430, binding = 8) writeonly buffer World { vec4 world[]; };
layout(std430, binding = 9) writeonly buffer Normal { vec4 normal[]; };
#endif

uniform uint vertices;
uniform dvec3 eye_point;
uniform dvec3 eye_row[3]; // of eye_from_world

void main()
{
    // One row of groups is too short for all vertices.
    uint vertex = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x
        + gl_LocalInvocationID.x;
    if (vertex >= vertices) return;
    PartData from = part[part_of[vertex]];
    uint at = 3u * (from.moving != 0u ? from.first + (vertex - from.first_vertex) : vertex);
    vec3 p;
    if (from.moving != 0u)
        p = vec3(moving_position[at], moving_position[at + 1u], moving_position[at + 2u]);
    else
        p = vec3(rest_position[at], rest_position[at + 1u], rest_position[at + 2u]);
    uint m = from.matrix;
    // In the order of src/scene/pose_kernel.cpp, then of src/visibility/project.cpp: the same bits.
    precise vec3 p_world;
    for (int row = 0; row < 3; ++row) {
        vec4 w = matrix[m].world[row];
        p_world[row] = ((w.x * p.x + w.y * p.y) + w.z * p.z) + w.w;
    }
    if (from.moving != 0u) p_world = p; // as it is
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
    bool has_direction = length2 >= 1e-30 && length2 <= 3.4e38; // of about 1
    normal[vertex] = vec4(has_direction ? moved / sqrt(length2) : vec3(0.0, 0.0, 1.0), 0.0);
#endif
}
