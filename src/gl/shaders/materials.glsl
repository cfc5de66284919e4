// materials.glsl - the scene's materials; models.glsl (material/glsl_models.h) fetches them.

layout(binding = 11) uniform samplerBuffer materials; // material/texels.h
