// materials.glsl - the buffer of the scene's materials, which models.glsl reads
// (material/glsl_models.h).

layout(binding = kMaterialsUnit) uniform samplerBuffer materials; // material/texels.h
