// scene.glsl - triangles as they are posed: see gl/scene_buffers.h.

layout(std430, binding = 0) readonly buffer Index { uint corner_index[]; };
layout(std430, binding = 1) readonly buffer Eye { vec4 eye_of_vertex[]; };
layout(std430, binding = 2) readonly buffer World { vec4 world_of_vertex[]; };
layout(std430, binding = 3) readonly buffer Normal { vec4 normal_of_vertex[]; };
layout(std430, binding = 4) readonly buffer TriangleMaterial { uint material_of_triangle[]; };
layout(std430, binding = 11) readonly buffer Uv { vec2 uv_of_vertex[]; }; // empty where there is none

uvec3 triangle_corners(uint triangle)
{
    uint first = 3u * triangle;
    return uvec3(corner_index[first], corner_index[first + 1u], corner_index[first + 2u]);
}

/// In the space of exact/pencil.h.
vec3 eye_position(uint vertex)
{
    return eye_of_vertex[vertex].xyz;
}

vec3 world_position(uint vertex)
{
    return world_of_vertex[vertex].xyz;
}

vec3 world_normal(uint vertex)
{
    return normal_of_vertex[vertex].xyz;
}

vec2 vertex_uv(uint vertex)
{
    return uv_of_vertex[vertex];
}

uint triangle_material(uint triangle)
{
    return material_of_triangle[triangle];
}
