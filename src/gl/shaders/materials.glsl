// materials.glsl - the scene's materials. The layout is that of gl/scene/gpu_data.h.

struct MaterialData {
    vec3 ambient;
    int texture_id; // -1: none
    vec3 diffuse;
    float shininess;
    vec3 specular;
    int whole_shininess; // the exponent, if it is whole and small, else -1
};

layout(binding = 11) uniform samplerBuffer materials; // three texels each

int material_texture(uint material)
{
    return floatBitsToInt(texelFetch(materials, 3 * int(material)).w);
}

MaterialData material_data(uint material)
{
    int first = 3 * int(material);
    vec4 ambient = texelFetch(materials, first);
    vec4 diffuse = texelFetch(materials, first + 1);
    vec4 specular = texelFetch(materials, first + 2);
    return MaterialData(ambient.xyz, floatBitsToInt(ambient.w), diffuse.xyz, diffuse.w,
        specular.xyz, floatBitsToInt(specular.w));
}
