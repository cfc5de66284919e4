// mesh_vertices.h - makes vertices from the corners of a mesh file.
#pragma once

#include "base/tasks.h"
#include "readers/mesh/raw_mesh.h"

#include <firsthit/mesh.h>

#include <cstddef>
#include <span>
#include <vector>

namespace firsthit {

/// Makes a mesh of each run of triangles. Vertices of a run with equal position, normal, texture
/// coordinates and colour become one, in order of first use; normals are made where the file has none.
/// The meshes do not depend on the number of threads.
///
/// first_triangle  (meshes) of each run, ascending from 0; a run ends where the next begins
std::vector<Mesh> make_meshes(RawMesh raw, std::span<const std::size_t> first_triangle,
    double crease_angle_rad, Tasks& tasks);

} // namespace firsthit
