// quartiles.h - what many measurements of the same thing say: the middle, and how far they spread.
#pragma once

#include "common/json.h"

#include <cstddef>
#include <vector>

namespace firsthit::cli::bench {

/// A quarter of the values lies below `lower`, half below `median`, a quarter above `upper`; between two
/// values linearly.
struct Quartiles {
    double lower = 0;
    double median = 0;
    double upper = 0;
    std::size_t count = 0; // 0: nothing was measured
};

/// values  none: all zero. They must be numbers.
Quartiles quartiles(std::vector<double> values);

/// Of 1000 / value: milliseconds to frames per second and back. What was lower becomes upper.
Quartiles per_second(const Quartiles& ms);

/// {"median", "lower", "upper", "count"}
Json quartiles_json(const Quartiles& values);

} // namespace firsthit::cli::bench
