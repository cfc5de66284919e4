// densest_window.h - where in a picture most of something is.
#pragma once

#include <firsthit/view.h>

#include <cstdint>
#include <span>

namespace firsthit::cli::bench {

/// The square that holds the most marks, of `side` pixels or as many as fit; the first of equals.
/// marks  (height, width) 0 or 1
Region densest_window(std::span<const std::uint8_t> marks, int width, int side);

} // namespace firsthit::cli::bench
