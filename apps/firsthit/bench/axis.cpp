// axis.cpp - from values to places along an axis, and which values to write beside it.
#include "bench/axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace firsthit::cli::bench {

namespace {

/// The step of about `count` ticks.
double nice_step(double range, int count)
{
    const double rough = range / count;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (rough <= factor * power * 1.0001) return factor * power;
    return 10 * power;
}

std::vector<double> linear_ticks(double low, double high, double step)
{
    std::vector<double> ticks;
    const auto first = static_cast<long>(std::ceil(low / step - 1e-6));
    const auto last = static_cast<long>(std::floor(high / step + 1e-6));
    for (long k = first; k <= last; ++k) ticks.push_back(double(k) * step);
    return ticks;
}

std::vector<double> log_ticks(double low, double high)
{
    std::vector<double> ticks;
    const bool few = high / low < 1000;
    for (int power = int(std::floor(std::log10(low) + 1e-9));
         std::pow(10.0, power) <= high * 1.0001; ++power)
        for (const double factor : {1.0, 2.0, 5.0}) {
            const double tick = factor * std::pow(10.0, power);
            if ((factor == 1 || few) && low * 0.9999 <= tick && tick <= high * 1.0001)
                ticks.push_back(tick);
        }
    return ticks;
}

/// The next 1, 2 or 5 times a power of ten, at or below (up: above) the value.
double round_log(double value, bool up)
{
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    double result = power;
    for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
        if (up && value <= factor * power * 1.0001) return factor * power;
        if (!up && factor * power <= value * 1.0001) result = factor * power;
    }
    return result;
}

} // namespace

Scale::Scale(const Axis& axis, const std::vector<double>& values) : log_(axis.log)
{
    bool any = false;
    for (const double value : values) {
        if (!std::isfinite(value) || (log_ && value <= 0)) continue;
        low_ = any ? std::min(low_, value) : value;
        high_ = any ? std::max(high_, value) : value;
        any = true;
    }
    if (!any) low_ = log_ ? 1 : 0, high_ = log_ ? 10 : 1;
    if (log_) {
        low_ = round_log(low_, false);
        high_ = round_log(high_, true);
        if (high_ <= low_) high_ = 10 * low_;
        ticks_ = log_ticks(low_, high_);
        return;
    }
    if (axis.from_zero) low_ = std::min(low_, 0.0), high_ = std::max(high_, 0.0);
    if (high_ <= low_) high_ = low_ + std::max(1.0, std::abs(low_));
    const double step = nice_step(high_ - low_, 6);
    // Heights end at a tick, so that none sticks out; what does not begin at 0 keeps its range.
    if (axis.from_zero)
        low_ = std::floor(low_ / step) * step, high_ = std::ceil(high_ / step) * step;
    ticks_ = linear_ticks(low_, high_, step);
}

bool Scale::holds(double value) const
{
    return std::isfinite(value) && (!log_ || value > 0);
}

double Scale::place(double value) const
{
    if (log_) return std::log(value / low_) / std::log(high_ / low_);
    return (value - low_) / (high_ - low_);
}

std::string tick_text(double value)
{
    const double size = std::abs(value);
    if (size >= 1e9 || (size > 0 && size < 1e-4)) return fmt::format("{:.3g}", value);
    if (size >= 1e6) return fmt::format("{:.6g}M", value / 1e6);
    if (size >= 1e4) return fmt::format("{:.6g}k", value / 1e3);
    return fmt::format("{:.6g}", value);
}

} // namespace firsthit::cli::bench
