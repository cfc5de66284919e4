// id_planes.h - the planes that follow from the items: instance, material, node.
#pragma once

#include "base/tasks.h"

#include <firsthit/film.h>
#include <firsthit/scene.h>
#include <firsthit/settings.h>

namespace firsthit {

/// Looks up what the seen triangles belong to, after any engine has drawn the items.
class IdPlanes {
  public:
    /// Writes the settings without these planes, but with the items where they are needed.
    void without(const Settings& settings, Settings& own);

    /// Fills the planes that the last call of without() took away, and takes the items away where nobody
    /// asked for them.
    void fill(const Scene& scene, Tasks& tasks, Film& film) const;

  private:
    bool wants_instance_ = false;
    bool wants_material_ = false;
    bool wants_node_ = false;
    bool wants_item_ = false;
};

} // namespace firsthit
