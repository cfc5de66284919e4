// unit_of_3mf.h - the unit of lengths of a 3MF file, which Assimp does not tell.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace firsthit {

/// The word behind `unit` in the model of a 3MF file, as "inch"; empty where it says none, or where the archive
/// cannot be read.
///
/// bytes  of the file: a ZIP archive
std::string unit_of_3mf(std::string_view bytes);

/// How many metres one of a unit of 3MF is: "micron", "millimeter", "centimeter", "inch", "foot", "meter".
/// Nothing for other words.
std::optional<double> metres_of_3mf_unit(std::string_view unit);

} // namespace firsthit
