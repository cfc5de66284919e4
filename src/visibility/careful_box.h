// careful_box.h - the samples of a triangle that reaches behind the eye.
#pragma once

#include "exact/hit.h"
#include "visibility/view_memory.h"

#include <optional>

namespace firsthit {

/// A box that holds every sample hit by the triangle, or nothing where no sample can be hit.
std::optional<InView> careful_box(
    std::uint32_t triangle, const Corners& corners, const Pencil& pencil);

} // namespace firsthit
