// quartiles.cpp - what many measurements of the same thing say: the middle, and how far they spread.
#include "bench/measure/quartiles.h"

#include <algorithm>
#include <cmath>

namespace firsthit::cli::bench {

namespace {

/// The value that the share lies below, of sorted values.
double quantile(const std::vector<double>& sorted, double share)
{
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (sorted[above] - sorted[below]) * (place - std::floor(place));
}

} // namespace

Quartiles quartiles(std::vector<double> values)
{
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    return {quantile(values, 0.25), quantile(values, 0.5), quantile(values, 0.75), values.size()};
}

Quartiles per_second(const Quartiles& ms)
{
    return {1000 / ms.upper, 1000 / ms.median, 1000 / ms.lower, ms.count};
}

Json quartiles_json(const Quartiles& values)
{
    return {{"median", values.median}, {"lower", values.lower}, {"upper", values.upper},
        {"count", values.count}};
}

} // namespace firsthit::cli::bench
