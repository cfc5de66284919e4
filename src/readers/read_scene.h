// read_scene.h - from a name to a sound scene, as its file has it.
#pragma once

#include <firsthit/scene.h>

#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace firsthit {

/// As load_scene, but a scene without lights gets none.
///
/// corners  where not null, and the file is a mesh file: (T) the file's own number of the vertex at each
///          corner, before vertices are welded and split; other files leave it empty
Scene read_scene(const std::string& name, const LoadSettings& settings,
    std::vector<glm::uvec3>* corners = nullptr);

} // namespace firsthit
