// texts.inl - the texts of all models, as C++. Included inside a namespace that has their words.
#include "material/surface.glsl"

#include "material/phong.glsl"
#include "material/unlit.glsl"
