// coco_rle.h - masks as runs down the columns, as the COCO data set writes them.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace firsthit::cli {

/// A mask of height x width pixels: how many pixels in turn are not and are in it, beginning with those
/// that are not (0 where the first is), column by column from the left, each from the top down.
struct CocoRle {
    std::uint32_t height = 0;
    std::uint32_t width = 0;
    std::vector<std::uint32_t> counts; // their sum is height * width
};

/// What a mask covers.
struct MaskShape {
    CocoRle rle;
    std::uint64_t area = 0; // pixels
    std::uint32_t x = 0;    // leftmost column of the smallest box around it
    std::uint32_t y = 0;    // topmost row
    std::uint32_t box_width = 0;
    std::uint32_t box_height = 0;
};

/// The mask of each id that a plane has, but for `none`.
/// ids  (height, width), row 0 at the top; at most 2^32 - 1 of them
std::map<std::uint32_t, MaskShape> masks_of(
    std::span<const std::uint32_t> ids, std::uint32_t width, std::uint32_t none);

/// The counts as COCO's compressed text: from the fourth on, less the one two before; each in groups of
/// five bits, the lowest first, bit 5 set where another follows, plus 48.
std::string compressed_counts(const CocoRle& rle);

} // namespace firsthit::cli
