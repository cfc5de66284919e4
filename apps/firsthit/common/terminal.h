// terminal.h - what the terminal that we write to can show.
#pragma once

#include <string>

namespace firsthit::cli {

/// Columns of the terminal that standard output is, 40 to 100; 80 where it is none, as in a pipe.
int text_columns();

/// A text in a colour of errors (red) or warnings (yellow), bold, where standard error is a terminal that
/// shows colours and NO_COLOR is not set; else the text.
std::string in_error_color(const std::string& text);
std::string in_warning_color(const std::string& text);

} // namespace firsthit::cli
