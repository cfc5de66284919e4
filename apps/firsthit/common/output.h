// output.h - text for the user: results to stdout, warnings to stderr.
#pragma once

#include <exception>
#include <string>
#include <string_view>
#include <vector>

namespace firsthit::cli {

/// Whoever read our standard output has gone, as `head` does: nothing is left to say.
class ReaderGone : public std::exception {};

/// throws  FileError where stdout takes no more (a full disk); ReaderGone
void print(std::string_view text);

/// "firsthit: warning: ..." a line each, to stderr. Nothing where --quiet was said.
void print_warnings(const std::vector<std::string>& warnings);

} // namespace firsthit::cli
