// problems.cpp - what is wrong in a file and was left out or repaired, a warning for each kind of it.
#include "readers/problems.h"

#include <fmt/format.h>

#include <algorithm>

namespace firsthit {

void Problems::add(std::string_view kind, std::string_view what, std::size_t number)
{
    if (last_ < kinds_.size() && kinds_[last_].text == kind) {
        ++kinds_[last_].count;
        return;
    }
    const auto found = std::find_if(
        kinds_.begin(), kinds_.end(), [&](const Kind& known) { return known.text == kind; });
    last_ = static_cast<std::size_t>(found - kinds_.begin());
    if (found != kinds_.end()) {
        ++found->count;
        return;
    }
    Kind& added = kinds_.emplace_back();
    added.text = kind;
    if (!what.empty()) added.place = fmt::format("{} {}", what, number);
    added.count = 1;
}

void Problems::add_times(
    std::string_view kind, std::size_t times, std::string_view what, std::size_t number)
{
    if (times == 0) return;
    add(kind, what, number);
    kinds_[last_].count += times - 1;
}

std::vector<std::string> Problems::lines(const std::string& name) const
{
    std::vector<std::string> lines;
    for (const Kind& kind : kinds_) {
        std::string line = fmt::format("{}: {}", name, kind.text);
        const std::string times = kind.count > 1 ? fmt::format("{} times", kind.count) : "";
        if (!kind.place.empty())
            line += fmt::format(" (first at {}{}{})", kind.place, times.empty() ? "" : ", ", times);
        else if (!times.empty())
            line += fmt::format(" ({})", times);
        lines.push_back(std::move(line));
    }
    return lines;
}

} // namespace firsthit
