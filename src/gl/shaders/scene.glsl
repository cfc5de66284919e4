// scene.glsl - triangles as they are posed: see gl/scene/scene_textures.h.
//
// Arrays are fetched as texels, as in the paper (section 4.2.1): drivers are faster at it than at
// storage blocks.

layout(binding = 5) uniform usamplerBuffer corner_index; // (T) the vertices of a triangle
layout(binding = 6) uniform samplerBuffer eye_of_vertex; // (V)
layout(binding = 7) uniform samplerBuffer world_of_vertex;
layout(binding = 8) uniform samplerBuffer normal_of_vertex;
layout(binding = 9) uniform samplerBuffer uv_of_vertex; // empty where there is none
layout(binding = 10) uniform usamplerBuffer material_of_triangle;

uvec3 triangle_corners(uint triangle)
{
    return texelFetch(corner_index, int(triangle)).xyz;
}

/// In the space of exact/pencil.h.
vec3 eye_position(uint vertex)
{
    return texelFetch(eye_of_vertex, int(vertex)).xyz;
}

vec3 world_position(uint vertex)
{
    return texelFetch(world_of_vertex, int(vertex)).xyz;
}

vec3 world_normal(uint vertex)
{
    return texelFetch(normal_of_vertex, int(vertex)).xyz;
}

vec2 vertex_uv(uint vertex)
{
    return texelFetch(uv_of_vertex, int(vertex)).xy;
}

uint triangle_material(uint triangle)
{
    return texelFetch(material_of_triangle, int(triangle)).x;
}
