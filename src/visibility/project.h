// project.h - vertices into eye space, once each.
#pragma once

#include "base/tasks.h"
#include "visibility/view_memory.h"

namespace firsthit {

/// Fills memory.corner from world positions and memory.pencil. Eye space is rounded
/// once from double, so equal positions get equal bits, on every instruction set.
void project_vertices(std::span<const glm::vec3> position, ViewMemory& memory, Tasks& tasks);

} // namespace firsthit
