// cutout_opacity.h - whether a cut-out is there at a point of it.
#pragma once

#include <firsthit/scene.h>

#include <cstdint>

namespace firsthit {

/// Whether a triangle of Cutouts is there where a ray hits it.
///
/// u, v          of the exact hit, each rounded once (rounded_barycentrics)
/// blend_cutoff  as Cutouts::find
bool is_solid_at(const Scene& scene, std::uint32_t triangle, float u, float v, float blend_cutoff);

} // namespace firsthit
