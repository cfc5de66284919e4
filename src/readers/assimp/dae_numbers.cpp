// dae_numbers.cpp - numbers of COLLADA texts, as Assimp 5.2 reads them.
#include "readers/assimp/dae_numbers.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace firsthit {

std::string without_blanks_before_numbers(const std::string& xml)
{
    constexpr std::string_view kBlanks = " \t\r\n";
    constexpr std::string_view kNumberBegins = "0123456789+-.";
    std::string text;
    text.reserve(xml.size());
    std::size_t at = 0;
    while (at < xml.size()) {
        const std::size_t tag_end = std::min(xml.find('>', at), xml.size() - 1) + 1;
        text.append(xml, at, tag_end - at);
        const std::size_t word = std::min(xml.find_first_not_of(kBlanks, tag_end), xml.size());
        const bool is_number =
            word < xml.size() && kNumberBegins.find(xml[word]) != kNumberBegins.npos;
        at = is_number ? word : tag_end;
    }
    return text;
}

} // namespace firsthit
