// check_animation.h - are clips, skins, morph targets and skin weights of a scene sound?
#pragma once

#include <firsthit/scene.h>

#include <string>

namespace firsthit {

/// Checks clips, and skins.
/// throws  SceneError: names the clip, channel or skin
void check_animation(const Scene& scene);

/// Checks the morph targets and skin weights of an instance, whose `shape` and `skin` exist or are -1.
///
/// what    names the instance in errors
/// throws  SceneError
void check_deformation(const Scene& scene, const Instance& instance, const std::string& what);

} // namespace firsthit
