// output.h - text for the user: results to stdout, warnings to stderr.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace firsthit::cli {

/// throws  FileError where stdout takes no more (a full disk)
void print(std::string_view text);

/// "firsthit: warning: ..." a line each, to stderr.
void print_warnings(const std::vector<std::string>& warnings);

} // namespace firsthit::cli
