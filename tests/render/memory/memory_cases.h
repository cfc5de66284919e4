// memory_cases.h - small worlds and settings that together make frames use every kind of memory.
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

/// The number of cases at the start of memory_cases() that cover the most in the least time.
inline constexpr std::size_t kQuickCases = 6;

struct FrameKind {
    std::string name;
    Settings settings;
};

/// Every kind of shadow with every set of planes that uses different code.
std::vector<FrameKind> frame_kinds(Engine engine);

/// All bytes of the film.
std::vector<std::byte> bytes_of(const Film& film);

} // namespace firsthit::test
