// wrap.cpp - text in lines that fit.
#include "help/wrap.h"

#include <algorithm>

namespace firsthit::cli {
namespace {

void add_wrapped_line(
    std::string_view line, std::size_t columns, std::size_t hanging, std::string& result)
{
    const std::size_t own = std::min(line.find_first_not_of(' '), line.size());
    const std::string indent(std::max(own, hanging), ' ');
    std::string rest(line);
    while (rest.size() > columns) {
        const std::size_t text = rest.find_first_not_of(' ');
        if (text == std::string::npos) break;
        std::size_t end = rest.rfind(' ', columns);
        if (end == std::string::npos || end < text) end = rest.find(' ', text);
        const std::size_t next = end == std::string::npos ? end : rest.find_first_not_of(' ', end);
        if (next == std::string::npos) break; // one word
        result += rest.substr(0, rest.find_last_not_of(' ', end) + 1) + '\n';
        rest = indent + rest.substr(next);
    }
    result += rest;
}

} // namespace

std::string wrapped(std::string_view text, std::size_t columns, std::size_t hanging)
{
    std::string result;
    for (;;) {
        const std::size_t end = text.find('\n');
        add_wrapped_line(text.substr(0, end), columns, hanging, result);
        if (end == std::string_view::npos) return result;
        result += '\n';
        text.remove_prefix(end + 1);
    }
}

} // namespace firsthit::cli
