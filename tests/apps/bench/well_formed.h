// well_formed.h - is a text well-formed XML? Enough of it for pages and plots.
#pragma once

#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace firsthit::cli::bench {

/// What is wrong; empty where nothing is: every tag is closed in its turn, attributes are quoted, and & begins
/// an entity.
inline std::string xml_error(std::string_view text)
{
    std::vector<std::string> open;
    bool any = false;
    const auto entity = [&](std::size_t at) {
        const std::size_t end = text.find(';', at);
        return end != std::string_view::npos && end - at < 10 && end > at + 1;
    };
    for (std::size_t k = 0; k < text.size(); ++k) {
        const std::string here(text.substr(k, 40));
        if (text[k] == '&' && !entity(k)) return "a bare & at: " + here;
        if (text[k] != '<') {
            if (open.empty() && !std::isspace(static_cast<unsigned char>(text[k])))
                return "text outside of the root: " + here;
            continue;
        }
        if (text.substr(k, 2) == "<!") {
            k = text.find('>', k);
            if (k == std::string_view::npos) return "a declaration without an end";
            continue;
        }
        // The tag's end, outside of quotes.
        std::size_t end = k + 1;
        char quote = 0;
        for (; end < text.size() && (quote || text[end] != '>'); ++end) {
            const char c = text[end];
            if (c == '<') return "a < in a tag: " + here;
            if (c == '&' && !entity(end)) return "a bare & in a tag: " + here;
            if (quote)
                quote = c == quote ? char(0) : quote;
            else if (c == '"' || c == '\'')
                quote = c;
            else if (c == '=' && text[end + 1] != '"')
                return "an attribute without quotes: " + here;
        }
        if (end >= text.size()) return "a tag without an end: " + here;
        const bool closes = text[k + 1] == '/', empty = text[end - 1] == '/';
        const std::size_t begin = k + 1 + closes;
        const std::string name(text.substr(begin, text.find_first_of(" \n/>", begin) - begin));
        if (name.empty() || !std::isalpha(static_cast<unsigned char>(name[0])))
            return "no name: " + here;
        if (closes) {
            if (open.empty() || open.back() != name) return "closes what is not open: " + here;
            open.pop_back();
        } else if (open.empty() && any)
            return "a second root: " + here;
        else if (!empty)
            open.push_back(name);
        any = true;
        k = end;
    }
    if (!open.empty()) return "is not closed: " + open.back();
    return any ? "" : "no element";
}

} // namespace firsthit::cli::bench
