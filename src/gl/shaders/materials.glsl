// materials.glsl - the scene's materials. The layout is that of gl/gpu_data.h.

struct MaterialData {
    vec3 ambient;
    int texture_id; // -1: none
    vec3 diffuse;
    float shininess;
    vec3 specular;
    int whole_shininess; // the exponent, if it is whole and small, else -1
};

layout(std430, binding = 5) readonly buffer Materials { MaterialData materials[]; };
