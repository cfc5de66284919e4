// mesh_vertices.h - makes the vertices of a scene from the corners of a mesh file.
#pragma once

#include "readers/mesh/raw_mesh.h"

#include <firsthit/scene.h>

namespace firsthit {

/// Fills position, normal, uv, index and the parts' vertex ranges. The triangles of the parts must
/// be known. Vertices of a part with equal position, normal and texture coordinates become one, in
/// order of first use; normals are made where the mesh has none.
void make_vertices(RawMesh raw, double crease_angle_rad, Scene& scene);

} // namespace firsthit
