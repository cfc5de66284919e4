// check_light.h - does a light keep its promises?
#pragma once

#include <firsthit/scene.h>

#include <string>

namespace firsthit {

/// What is wrong with a light, with its value and what is accepted; empty where it is sound: a
/// position and a colour that are finite and, where the kind asks for them, a direction whose
/// length is 1e-100 to 1e100 and a cone with 0 <= inner <= outer, 0 < outer < pi / 2.
std::string fault_of(const Light& light);

/// Of all lights of a world, whoever made it. Allocates nothing where all are sound.
/// throws  SceneError: names the scene, the light and the fault
void check_lights(const World& world);

} // namespace firsthit
