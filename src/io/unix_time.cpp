// unix_time.cpp - times in ISO 8601.
#include "io/text_cursor.h"

#include <firsthit/error.h>
#include <firsthit/sun.h>

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>

namespace firsthit {
namespace {

/// Takes the parts of a time off a text, from the front.
class TimeText {
  public:
    explicit TimeText(std::string_view text) : text_(text) {}

    bool empty() const { return text_.empty(); }

    /// So many digits.
    std::optional<int> digits(std::size_t count)
    {
        if (text_.size() < count) return {};
        int value = 0;
        for (std::size_t k = 0; k < count; ++k) {
            if (text_[k] < '0' || '9' < text_[k]) return {};
            value = 10 * value + (text_[k] - '0');
        }
        text_.remove_prefix(count);
        return value;
    }

    bool take(char c)
    {
        if (text_.empty() || text_[0] != c) return false;
        text_.remove_prefix(1);
        return true;
    }

    /// What follows a point, as a share of 1; at least one digit.
    std::optional<double> fraction()
    {
        double value = 0, unit = 0.1;
        bool any = false;
        while (!text_.empty() && '0' <= text_[0] && text_[0] <= '9') {
            value += unit * (text_[0] - '0');
            unit *= 0.1;
            any = true;
            text_.remove_prefix(1);
        }
        if (!any) return {};
        return value;
    }

  private:
    std::string_view text_;
};

/// Seconds to take away for the zone at the end; nothing where there is none.
std::optional<int> zone_s(TimeText& text)
{
    if (text.take('Z')) return 0;
    const bool east = text.take('+');
    if (!east && !text.take('-')) return {};
    const std::optional<int> hours = text.digits(2);
    const bool colon = text.take(':');
    const std::optional<int> minutes =
        text.empty() && !colon ? std::optional<int>(0) : text.digits(2);
    if (!hours || !minutes || *hours > 23 || *minutes > 59) return {};
    return (east ? 1 : -1) * (*hours * 3600 + *minutes * 60);
}

std::optional<double> parse_iso(std::string_view whole)
{
    TimeText text(whole);
    const auto year = text.digits(4);
    const bool first = text.take('-');
    const auto month = text.digits(2);
    const bool second = text.take('-');
    const auto day = text.digits(2);
    if (!year || !first || !month || !second || !day || !text.take('T')) return {};
    const auto hour = text.digits(2);
    const bool colon = text.take(':');
    const auto minute = text.digits(2);
    if (!hour || !colon || !minute || *hour > 23 || *minute > 59) return {};
    double second_s = 0;
    if (text.take(':')) {
        const auto seconds = text.digits(2);
        if (!seconds || *seconds > 59) return {};
        second_s = *seconds;
        if (text.take('.')) {
            const auto fraction = text.fraction();
            if (!fraction) return {};
            second_s += *fraction;
        }
    }
    const std::optional<int> zone = zone_s(text);
    if (!zone || !text.empty() || *year < 1800 || *year >= 2200) return {};
    const std::chrono::year_month_day date{std::chrono::year(*year),
        std::chrono::month(static_cast<unsigned>(*month)),
        std::chrono::day(static_cast<unsigned>(*day))};
    if (!date.ok()) return {};
    const double days = static_cast<double>(std::chrono::sys_days(date).time_since_epoch().count());
    return days * 86400 + *hour * 3600 + *minute * 60 + second_s - *zone;
}

} // namespace

double unix_time(const std::string& text)
{
    if (const std::optional<double> time = parse_iso(text)) return *time;
    throw ArgumentError(
        fmt::format("'{}' is no time: accepted is ISO 8601 with the zone, of the years 1800 to "
                    "2199, as 2026-06-21T12:00Z or 2026-06-21T14:00:30+02:00",
            printable(text)));
}

} // namespace firsthit
