// environment_tables.glsl - what environment.glsl looks up in: EnvironmentMap on OpenGL.

#if FIRSTHIT_ENVIRONMENT
layout(binding = kEnvironmentUnit) uniform samplerBuffer environment_texels;

struct EnvironmentTables {
    int unused; // all is in the frame and in the buffer
};

vec3 diffuse_term(EnvironmentTables tables, int k)
{
    return frame.environment_diffuse[k].xyz;
}

float level_side(EnvironmentTables tables, float level)
{
    return frame.environment_level[int(level)].x;
}

float level_first(EnvironmentTables tables, float level)
{
    return frame.environment_level[int(level)].y;
}

float table_first(EnvironmentTables tables)
{
    return frame.environment_table;
}

vec3 weighted_light(EnvironmentTables tables, int top, int bottom, FourWeights weights)
{
    vec3 sum = texelFetch(environment_texels, top).xyz * weights.top_left;
    sum += texelFetch(environment_texels, top + 1).xyz * weights.top_right;
    sum += texelFetch(environment_texels, bottom).xyz * weights.bottom_left;
    return sum + texelFetch(environment_texels, bottom + 1).xyz * weights.bottom_right;
}

float environment_strength(EnvironmentTables tables)
{
    return frame.environment_strength;
}

vec3 turned_back(vec3 d, float cosine, float sine);

vec3 environment_space(EnvironmentTables tables, vec3 d)
{
    return turned_back(d, frame.environment_cosine, frame.environment_sine);
}

#include "environment.glsl"
#endif
