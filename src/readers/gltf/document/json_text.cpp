// json_text.cpp - checks the nesting and number of values of a JSON text, then parses it.
#include "readers/gltf/document/json_text.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <cstddef>

namespace firsthit::gltf {
namespace {

constexpr std::size_t kMaxDepth = 64;
constexpr std::size_t kMaxValues = std::size_t(1) << 24; // a value takes 16 to 100 bytes

/// Of the text that starts at `open`: the first quote with an even number of backslashes before it.
std::size_t closing_quote(std::string_view text, std::size_t open)
{
    for (std::size_t at = text.find('"', open + 1); at != std::string_view::npos;
         at = text.find('"', at + 1)) {
        std::size_t backslashes = 0;
        while (text[at - 1 - backslashes] == '\\') ++backslashes;
        if (backslashes % 2 == 0) return at;
    }
    return std::string_view::npos;
}

/// Counts brackets and separators outside strings.
void check_limits(std::string_view text, const std::string& name)
{
    std::size_t depth = 0, values = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        switch (text[at]) {
        case '"':
            at = closing_quote(text, at);
            if (at == std::string_view::npos) return; // the parser says where
            break;
        case '[':
        case '{':
            ++values;
            if (++depth > kMaxDepth)
                throw FileError(
                    fmt::format("{}: JSON values are nested more than {} deep at byte {}", name,
                        kMaxDepth, at));
            break;
        case ']':
        case '}':
            if (depth > 0) --depth;
            break;
        case ',':
        case ':':
            ++values;
            break;
        default:
            break;
        }
    }
    if (values > kMaxValues)
        throw FileError(
            fmt::format("{}: {} JSON values, at most {} are accepted", name, values, kMaxValues));
}

} // namespace

Json parse_json(std::string_view text, const std::string& name, const char* kind)
{
    check_limits(text, name);
    try {
        return Json::parse(text);
    } catch (const Json::exception& error) {
        // "[json.exception.parse_error.101] parse error at line 1, column 2: ...": without its number.
        std::string_view reason = error.what();
        if (const std::size_t end = reason.find("] "); end != std::string_view::npos)
            reason.remove_prefix(end + 2);
        throw FileError(fmt::format("{}: not {}: {}", name, kind, reason));
    }
}

} // namespace firsthit::gltf
