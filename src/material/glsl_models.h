// glsl_models.h - writes GLSL for the shading models of models.h.
#pragma once

#include <string>

namespace firsthit {

/// Returns GLSL that is generated from the table in models.h: the structs of all models, includes
/// of their formulas (`#include "phong.glsl"`), functions that load a material, and a type that can
/// hold the inputs of any model:
///
///     struct Inputs
///     int material_model(uint material)
///     int map_count(int model)          how many maps it has
///     int normal_map(int model)         which of them is a normal map, or -1
///     float normal_scale(uint material, int model)
///     Inputs inputs_of(uint material, vec3 texture_color, MapColors maps)
///     vec3 albedo(Inputs inputs)
///     vec3 emitted(Inputs inputs, vec3 ambient_light)
///     bool reflects(Inputs inputs)
///     bool reflects_environment(Inputs inputs)
///     vec3 surrounded(Inputs inputs, AroundLight around)
///     float metallic(Inputs inputs), float roughness(Inputs inputs), vec3 emission(Inputs inputs)
///     vec3 reflected(Inputs inputs, Surface surface, vec3 to_light, vec3 light)
///
/// A shader includes it after material/surface.glsl and after the declaration of a `samplerBuffer
/// materials` that holds material_texels. FIRSTHIT_ONLY_MODEL must be defined as the number of the
/// only model in the scene, or as -1 if there are several.
std::string glsl_models();

} // namespace firsthit
