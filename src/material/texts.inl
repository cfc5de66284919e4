// texts.inl - includes the formulas of all models as C++. The including namespace defines `real`
// and the other types that they use.
#include "material/surface.glsl"

#include "material/phong.glsl"
#include "material/unlit.glsl"
#include "material/metallic_roughness.glsl"
