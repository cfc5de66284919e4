// multisample.h - how OpenGL's item buffer is repaired.
#pragma once

namespace firsthit {

/// Item repair: what the OpenGL engines do if a ray does not hit the triangle that the item buffer
/// names (Robert and Schoepke 2006, section 4.1). The cpu engine's items are exact and need no
/// repair.
enum class Multisample {
    none,  // no repair
    lazy3, // after a miss, test the items of the 3 x 3 pixels around; the nearest hit wins
    lazy5, // the same with 5 x 5 pixels
    full3, // for every pixel, test the items of the 3 x 3 pixels around; the nearest hit wins
    full5, // the same with 5 x 5 pixels
    exact, // decide uncertain pixels exactly on the CPU: the items are those of the cpu engine
};

} // namespace firsthit
