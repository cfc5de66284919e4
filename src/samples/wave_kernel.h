// wave_kernel.h - heights and normals of a row of the wave's cloth.
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>

namespace firsthit {

inline constexpr std::size_t kWaveCount = 3;

/// Columns may be read this far beyond the last.
inline constexpr std::size_t kWavePadding = 16;

/// What vertices share by column, at all times.
struct WaveColumns {
    const float* x;
    std::array<const float*, kWaveCount> sine, cosine; // of a x
};

/// What a row's vertices share at one time.
struct WaveRow {
    float z = 0;
    std::array<float, kWaveCount> p{}; // A cos(b z + w t)
    std::array<float, kWaveCount> q{}; // A sin(b z + w t)
    std::array<float, kWaveCount> a{}, b{};
};

/// Positions and unit normals of `count` vertices from a column on. The same bits for every
/// instruction set.
void fill_wave(const WaveColumns& columns, const WaveRow& row, std::size_t column,
    std::size_t count, glm::vec3* position, glm::vec3* normal);

} // namespace firsthit
