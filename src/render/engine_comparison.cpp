// engine_comparison.cpp - totals of engine comparisons.
#include <firsthit/compare.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace firsthit {
namespace {

/// Peak signal to noise ratio in decibels. A pixel has three channels.
double psnr(double square_sum, std::uint64_t pixels)
{
    return square_sum > 0 ? 10 * std::log10(3 * double(pixels) / square_sum)
                          : std::numeric_limits<double>::infinity();
}

} // namespace

double EngineComparison::psnr_db() const
{
    return psnr(square_sum, pixels);
}

std::optional<double> EngineComparison::psnr_same_items_db() const
{
    if (!square_sum_same_items) return std::nullopt;
    return psnr(*square_sum_same_items, pixels);
}

EngineComparison operator+(const EngineComparison& a, const EngineComparison& b)
{
    if (a.pixels == 0) return b;
    if (b.pixels == 0) return a;
    EngineComparison sum{
        .pixels = a.pixels + b.pixels,
        .missed = a.missed + b.missed,
        .wrong = a.wrong + b.wrong,
        .ties = a.ties + b.ties,
        .interpolated = a.interpolated + b.interpolated,
        .square_sum = a.square_sum + b.square_sum,
        .largest_difference = std::max(a.largest_difference, b.largest_difference),
        .square_sum_same_items = std::nullopt,
    };
    if (a.square_sum_same_items && b.square_sum_same_items)
        sum.square_sum_same_items = *a.square_sum_same_items + *b.square_sum_same_items;
    return sum;
}

} // namespace firsthit
