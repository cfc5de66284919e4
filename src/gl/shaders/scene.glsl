// scene.glsl - triangles as they are posed, and their materials: see gl/scene_buffers.h.

layout(std430, binding = 0) readonly buffer Index { uint index_of[]; };
layout(std430, binding = 1) readonly buffer Posed { vec4 posed[]; };
layout(std430, binding = 2) readonly buffer World { vec4 world[]; };
layout(std430, binding = 3) readonly buffer Uv { vec2 uv_of[]; };
layout(std430, binding = 4) readonly buffer TriangleMaterial { uint material_of[]; };

uvec3 triangle_corners(uint triangle)
{
    return uvec3(index_of[3u * triangle], index_of[3u * triangle + 1u], index_of[3u * triangle + 2u]);
}

vec3 eye_position(uint vertex)
{
    return posed[2u * vertex].xyz;
}

vec3 world_normal(uint vertex)
{
    return posed[2u * vertex + 1u].xyz;
}

vec3 world_position(uint vertex)
{
    return world[vertex].xyz;
}

bool has_uv()
{
    return true;
}

vec2 vertex_uv(uint vertex)
{
    return uv_of[vertex];
}

uint triangle_material(uint triangle)
{
    return material_of[triangle];
}
