// stages.h - the stages of a frame that bars show, with their colours.
#pragma once

#include <firsthit/stats.h>

#include <array>
#include <cstdint>
#include <span>

namespace firsthit::cli::view {

struct Stage {
    const char* name;
    double Stats::*ms;
    std::array<std::uint8_t, 3> color; // sRGB
};

/// All of them, in the order in which they are piled up.
std::span<const Stage> all_stages();

/// What takes time in none of them.
inline constexpr std::array<std::uint8_t, 3> kOtherStage{110, 110, 110};

/// The milliseconds of a frame that are in none of the stages.
double other_ms(const Stats& stats, double made_ms);

} // namespace firsthit::cli::view
