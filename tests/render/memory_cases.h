// memory_cases.h - small worlds and ways to make their pictures, between which frames meet every kind of
// memory that they use.
#pragma once

#include "shadow/shadow_scenes.h"

#include <firsthit/render.h>

#include <cstddef>
#include <string>
#include <vector>

namespace firsthit::test {

struct MemoryCase {
    std::string name;
    ShadowWorld made;
};

/// A few of the library's own scenes and all shadow scenes, lit, 64 to 128 pixels on a side.
std::vector<MemoryCase> memory_cases();

/// Those that meet the most in the least time: the first so many of memory_cases().
inline constexpr std::size_t kQuickCases = 6;

struct FrameKind {
    std::string name;
    Settings settings;
};

/// Every kind of shadow with every set of planes that takes another way through a frame.
std::vector<FrameKind> frame_kinds(Engine engine);

/// All that the film holds, byte for byte.
std::vector<std::byte> bytes_of(const Film& film);

} // namespace firsthit::test
