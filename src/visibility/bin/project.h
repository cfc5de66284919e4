// project.h - transforms vertices into eye space.
#pragma once

#include "base/tasks.h"
#include "exact/pencil.h"
#include "visibility/bin/eye_mesh.h"

#include <glm/vec3.hpp>

#include <span>

namespace firsthit {

/// Fills mesh.corner with the vertices in the pencil's eye space, and sets mesh.corner_space. Each
/// coordinate is computed in double and rounded once; flat coordinates are computed from the
/// rounded ones in eye space and rounded again. Equal positions get equal bits, on every
/// instruction set. Of an orthographic camera's pencil, the triangles that reach behind its eye become
/// cut-outs of the mesh.
///
/// position  (V) in world space
void project_vertices(std::span<const glm::vec3> position, const Pencil& pencil, EyeMesh& mesh,
    Tasks& tasks, CornerSpace space = CornerSpace::eye);

} // namespace firsthit
