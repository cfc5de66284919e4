// scan_number.cpp - numbers whose form is seldom.
#include "io/scan_number.h"

namespace firsthit::scanning {

const char* scan_any_float(const char* at, const char* end, float& value)
{
    const char* stop = at;
    while (stop != end && !is_word_end(*stop)) ++stop;
    const std::optional<float> number =
        parse_float(std::string_view(at, static_cast<std::size_t>(stop - at)));
    if (!number) return nullptr;
    value = *number;
    return stop;
}

} // namespace firsthit::scanning
