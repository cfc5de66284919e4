// png_rows.h - writes a .png row by row.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace firsthit {

/// A picture that gives its rows as a file holds them.
struct PngRows {
    int width = 0;
    int height = 0;
    int color_type = 0; // PNG_COLOR_TYPE_...
    int bit_depth = 8;  // 8, or 16, whose upper byte comes first
    std::size_t row_bytes = 0;
    std::function<void(int y, std::span<std::uint8_t> bytes)> fill{}; // must not throw

    /// Whether its codes are sRGB's: 8 bits of colours.
    bool is_srgb() const;
};

/// throws  FileError
void write_png_rows(const PngRows& rows, const std::string& path);

} // namespace firsthit
