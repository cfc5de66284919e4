// occlusion_tables.h - answers of `firsthit occlusion` as CSV.
#pragma once

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace firsthit::cli {

/// x,y,z,hours of each point. throws  FileError
void write_hours_csv(
    const std::string& path, std::span<const glm::vec3> points, std::span<const double> hours);

/// x,y,z and 0 or 1 for each light, of each point.
///
/// bits    (lights, ceil(N / 8)) as pack_bits makes them
/// throws  FileError
void write_answers_csv(const std::string& path, std::span<const glm::vec3> points,
    std::span<const std::uint8_t> bits, std::size_t lights);

} // namespace firsthit::cli
