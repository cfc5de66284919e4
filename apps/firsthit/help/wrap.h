// wrap.h - text in lines that fit.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace firsthit::cli {

/// Breaks lines that are longer than `columns` at spaces. What goes on is indented as its line is, or by
/// `hanging` columns. Words that are longer than a line stay whole.
std::string wrapped(std::string_view text, std::size_t columns, std::size_t hanging = 0);

} // namespace firsthit::cli
