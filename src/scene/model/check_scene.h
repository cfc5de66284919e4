// check_scene.h - does a scene keep its promises?
#pragma once

#include <firsthit/scene.h>

namespace firsthit {

/// Holds a scene against what scene.h says of it, so that nobody after the readers has to: indices
/// and numbers in range, coordinates finite, parents before children, parts in order without gaps,
/// fewer triangles than kNoItem. One pass over the memory. A part that deforms is not called.
///
/// throws  SceneError: names the scene, the element and the value
void check_scene(const Scene& scene);

} // namespace firsthit
