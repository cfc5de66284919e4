// project.h - vertices into eye space, once each.
#pragma once

#include "base/tasks.h"
#include "visibility/bin/view_memory.h"

namespace firsthit {

/// Fills memory.corner from world positions and memory.pencil, and says in memory.corner_space what
/// they are. Eye space is rounded once from double, and so is what is flat from eye space: equal
/// positions get equal bits, on every instruction set.
void project_vertices(std::span<const glm::vec3> position, ViewMemory& memory, Tasks& tasks,
    CornerSpace space = CornerSpace::eye);

} // namespace firsthit
