// frame_pattern.cpp - names of numbered files, as out_%04d.png.
#include "options/frame_pattern.h"

#include "common/usage.h"

#include <fmt/format.h>

namespace firsthit::cli {

FramePattern::FramePattern(const std::string& text)
{
    const auto refuse = [&](const char* reason) {
        throw UsageError(
            fmt::format("'{}' {}: the names of frames need exactly one place for their "
                        "number, as in out_%04d.png",
                text, reason));
    };
    bool found = false;
    for (std::size_t k = 0; k < text.size(); ++k) {
        std::string& part = found ? after_ : before_;
        if (text[k] != '%') {
            part += text[k];
            continue;
        }
        ++k;
        if (k < text.size() && text[k] == '%') {
            part += '%';
            continue;
        }
        if (found) refuse("has more than one %");
        if (k < text.size() && text[k] == '0') {
            fill_ = '0';
            ++k;
        }
        if (k < text.size() && '1' <= text[k] && text[k] <= '9') {
            width_ = static_cast<std::size_t>(text[k] - '0');
            ++k;
        }
        if (k >= text.size() || text[k] != 'd') refuse("has a % that is not %d, %4d or %04d");
        found = true;
    }
    if (!found) refuse("has no %d");
}

std::string FramePattern::name(int number) const
{
    const std::string digits = std::to_string(number);
    const std::size_t missing = width_ > digits.size() ? width_ - digits.size() : 0;
    return before_ + std::string(missing, fill_) + digits + after_;
}

bool looks_like_pattern(const std::string& text)
{
    for (std::size_t k = 0; k + 1 < text.size(); ++k)
        if (text[k] == '%' && (text[k + 1] == 'd' || ('0' <= text[k + 1] && text[k + 1] <= '9')))
            return true;
    return false;
}

} // namespace firsthit::cli
