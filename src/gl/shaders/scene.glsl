// scene.glsl - the posed triangles of the scene: see gl/scene/scene_textures.h.
//
// Arrays are read as texels, as in the paper (section 4.2.1), which is faster than reading storage
// blocks.
#include "gl/bindings.glsl"

layout(binding = kIndexUnit) uniform usamplerBuffer corner_index; // (T) the vertices of a triangle
layout(binding = kEyeUnit) uniform samplerBuffer eye_of_vertex; // (V)
layout(binding = kWorldUnit) uniform samplerBuffer world_of_vertex;
layout(binding = kNormalUnit) uniform samplerBuffer normal_of_vertex;
layout(binding = kUvUnit) uniform samplerBuffer uv_of_vertex; // empty if the scene has none
layout(binding = kTriangleMaterialUnit) uniform usamplerBuffer material_of_triangle;
// Empty if the scene has none.
layout(binding = kSecondUvUnit) uniform samplerBuffer second_uv_of_vertex;
layout(binding = kVertexColorUnit) uniform samplerBuffer color_of_vertex;
layout(binding = kTangentUnit) uniform samplerBuffer tangent_of_vertex;

uvec3 triangle_corners(uint triangle)
{
    return texelFetch(corner_index, int(triangle)).xyz;
}

/// In eye space (exact/pencil.h).
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

vec2 vertex_second_uv(uint vertex)
{
    return texelFetch(second_uv_of_vertex, int(vertex)).xy;
}

vec3 vertex_color(uint vertex)
{
    return texelFetch(color_of_vertex, int(vertex)).rgb;
}

vec4 world_tangent(uint vertex)
{
    return texelFetch(tangent_of_vertex, int(vertex));
}

uint triangle_material(uint triangle)
{
    return texelFetch(material_of_triangle, int(triangle)).x;
}
