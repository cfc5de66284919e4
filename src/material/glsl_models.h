// glsl_models.h - the models of models.h as one text for shaders.
#pragma once

#include <string>

namespace firsthit {

/// GLSL that goes by the table: the structs of all models, the texts (as `#include "phong.glsl"`),
/// how a material is fetched, and a type that can be any of them:
///
///     struct Inputs
///     Inputs inputs_of(uint material, vec3 texture_color)
///     vec3 albedo(Inputs inputs)
///     vec3 emitted(Inputs inputs, vec3 ambient_light)
///     bool reflects(Inputs inputs)
///     vec3 reflected(Inputs inputs, Surface surface, vec3 to_light, vec3 light)
///
/// After material/surface.glsl, and a `samplerBuffer materials` of material_texels. The define
/// FIRSTHIT_ONLY_MODEL is the model of all materials, or -1 where they have several.
std::string glsl_models();

} // namespace firsthit
