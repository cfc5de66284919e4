// stl_colors.h - colours in the two spare bytes of binary STL facets.
#pragma once

#include <glm/vec4.hpp>

#include <cstddef>
#include <vector>

namespace firsthit {

/// The colours of facets, linear, by one of two conventions. A header with "COLOR=" and four bytes
/// (Materialise Magics) gives a colour to all facets whose bit 15 is set; the others have their own, red
/// in the lowest bits. Else (VisCAM, SolidView) facets whose bit 15 is set have their own, blue in the
/// lowest bits, and the others none, which is grey.
///
/// header   80 bytes
/// facets   (count, 50) bytes
/// returns  (count), or empty where no facet has a colour
std::vector<glm::vec4> stl_colors(const char* header, const char* facets, std::size_t count);

} // namespace firsthit
