// frame_pattern.cpp - names of numbered files, as out_%04d.png.
#include "inputs/frame_pattern.h"

#include "common/usage.h"

#include <firsthit/error.h>

namespace firsthit::cli {

namespace {

FilePattern parse(const std::string& text)
{
    try {
        return FilePattern(text);
    } catch (const ArgumentError& error) {
        throw UsageError(error.what());
    }
}

} // namespace

FramePattern::FramePattern(const std::string& text) : pattern_(parse(text)) {}

bool looks_like_pattern(const std::string& text)
{
    for (std::size_t k = 0; k + 1 < text.size(); ++k)
        if (text[k] == '%' && (text[k + 1] == 'd' || ('0' <= text[k + 1] && text[k + 1] <= '9')))
            return true;
    return false;
}

} // namespace firsthit::cli
