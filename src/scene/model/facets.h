// facets.h - meshes whose triangles are flat.
#pragma once

#include <firsthit/mesh.h>

namespace firsthit {

/// Gives every triangle three vertices of its own, with the normal of its plane; (0, 0, 1) where it has no
/// area. All other arrays, morph targets and skin weights follow. Indices are in range.
void make_facets(Mesh& mesh);

} // namespace firsthit
