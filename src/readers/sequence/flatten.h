// flatten.h - a scene at one time, without what moves it.
#pragma once

#include <firsthit/scene.h>

namespace firsthit {

/// Poses a scene at the begin of its first clip and keeps where everything is then: vertices, lights and
/// cameras are in world space, nodes do not move, and there are no clips, skins and morph targets left.
/// throws  SceneError: a posed coordinate that is not finite
void flatten(Scene& scene);

} // namespace firsthit
