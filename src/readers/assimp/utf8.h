// utf8.h - text of two bytes a letter as UTF-8.
#pragma once

#include <string>

namespace firsthit {

/// The text as UTF-8, where it begins with the mark of UTF-16 (of either byte order); else as it is. Halves of
/// pairs without the other become U+FFFD.
std::string as_utf8(const std::string& text);

} // namespace firsthit
