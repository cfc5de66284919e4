// axis.h - from values to places along an axis, and which values to write beside it.
#pragma once

#include <string>
#include <vector>

namespace firsthit::cli::bench {

struct Axis {
    std::string label;     // with the unit
    bool log = false;      // powers of ten are equally far apart; values must be above 0
    bool from_zero = true; // not log: the axis begins at 0
};

/// An axis that holds all values, and its ticks.
class Scale {
  public:
    /// values  what is to be shown; what is not finite, or not above 0 on a log axis, is not looked at
    Scale(const Axis& axis, const std::vector<double>& values);

    bool holds(double value) const;

    /// 0 at the axis' begin, 1 at its end.
    double place(double value) const;

    /// Rising: steps of 1, 2 or 5 times a power of ten; of a log axis powers of ten, with 2 and 5 times
    /// these where there are few.
    const std::vector<double>& ticks() const { return ticks_; }

  private:
    bool log_;
    double low_ = 0;
    double high_ = 1;
    std::vector<double> ticks_;
};

/// "0.5", "20", "5k", "10M"
std::string tick_text(double value);

} // namespace firsthit::cli::bench
