// multisample.h - how OpenGL's item buffer is repaired.
#pragma once

namespace firsthit {

/// What the OpenGL engines do where the triangle that the item buffer names is not hit (section
/// 4.1). The cpu engine's item buffer names the triangle that is hit: it has nothing to repair.
enum class Multisample {
    none,  // nothing
    lazy3, // try the triangles of the 3 x 3 neighbourhood
    lazy5, // of 5 x 5
    full3, // try those of 3 x 3 at every pixel, the nearest hit wins
    full5, // of 5 x 5
    exact, // find the pixels that are not certain and decide them exactly: the cpu engine's items
};

} // namespace firsthit
