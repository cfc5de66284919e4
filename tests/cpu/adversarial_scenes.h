// adversarial_scenes.h - triangles that break rasterisers which are only nearly right.
#pragma once

#include "scenes.h"

#include <functional>
#include <random>
#include <string>

namespace firsthit::test {

struct AdversarialScene {
    std::string name;
    std::function<void(TestWorld&, std::mt19937&)> fill;
};

/// Picture size and focal length that the scenes are made for: pixel centres are at half integers
/// of x / z, y / z in a straight_view(kSize, kSize, kSize).
inline constexpr int kSize = 48;

/// Each fills a world seen by straight_view(kSize, kSize, kSize): world x = eye x / kSize.
const std::vector<AdversarialScene>& adversarial_scenes();

/// Those of triangles about as large as a pixel.
void add_tiny_scenes(std::vector<AdversarialScene>& scenes);

} // namespace firsthit::test
