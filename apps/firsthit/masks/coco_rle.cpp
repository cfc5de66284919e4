// coco_rle.cpp - masks as runs down the columns, as the COCO data set writes them.
#include "masks/coco_rle.h"

#include <algorithm>
#include <cstddef>

namespace firsthit::cli {
namespace {

constexpr std::size_t kColumnsAtOnce = 16; // a cache line of a row

/// A mask that grows along the columns.
struct GrowingMask {
    MaskShape shape;
    std::uint64_t end = 0; // the pixel after its last run
    std::uint32_t last_x = 0, last_y = 0;
};

/// Columns of a picture, one after the other, copied out of its rows.
void copy_columns(std::span<const std::uint32_t> ids, std::size_t width, std::size_t first,
    std::vector<std::uint32_t>& columns)
{
    const std::size_t height = ids.size() / width;
    const std::size_t count = std::min(kColumnsAtOnce, width - first);
    columns.resize(count * height);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < count; ++x)
            columns[x * height + y] = ids[y * width + first + x];
}

/// Adds the pixels [begin, end) of the order of columns, which lie in one column.
void add_run(GrowingMask& mask, std::uint64_t begin, std::uint64_t end, std::uint32_t height)
{
    MaskShape& shape = mask.shape;
    const auto x = std::uint32_t(begin / height), top = std::uint32_t(begin % height);
    const auto bottom = std::uint32_t((end - 1) % height);
    if (shape.area == 0) {
        shape.x = x;
        shape.y = top;
        mask.last_y = bottom;
    }
    shape.y = std::min(shape.y, top);
    mask.last_y = std::max(mask.last_y, bottom);
    mask.last_x = x;
    if (begin == mask.end && begin > 0) {
        shape.rle.counts.back() += std::uint32_t(end - begin); // goes on at the top of a column
    } else {
        shape.rle.counts.push_back(std::uint32_t(begin - mask.end));
        shape.rle.counts.push_back(std::uint32_t(end - begin));
    }
    shape.area += end - begin;
    mask.end = end;
}

} // namespace

std::map<std::uint32_t, MaskShape> masks_of(
    std::span<const std::uint32_t> ids, std::uint32_t width, std::uint32_t none)
{
    std::map<std::uint32_t, GrowingMask> growing;
    const auto height = std::uint32_t(width > 0 ? ids.size() / width : 0);
    std::vector<std::uint32_t> columns;
    for (std::size_t first = 0; first < width; first += kColumnsAtOnce) {
        copy_columns(ids, width, first, columns);
        for (std::size_t column = 0; column < columns.size(); column += height) {
            const std::uint32_t* pixel = columns.data() + column;
            const std::uint64_t place = first * height + column;
            for (std::uint32_t y = 0; y < height;) {
                const std::uint32_t id = pixel[y], begin = y;
                while (y < height && pixel[y] == id) ++y;
                if (id != none) add_run(growing[id], place + begin, place + y, height);
            }
        }
    }
    std::map<std::uint32_t, MaskShape> masks;
    for (auto& [id, mask] : growing) {
        MaskShape& shape = mask.shape;
        shape.box_width = mask.last_x - shape.x + 1;
        shape.box_height = mask.last_y - shape.y + 1;
        shape.rle.height = height;
        shape.rle.width = width;
        if (mask.end < ids.size()) shape.rle.counts.push_back(std::uint32_t(ids.size() - mask.end));
        masks.emplace(id, std::move(shape));
    }
    return masks;
}

std::string compressed_counts(const CocoRle& rle)
{
    std::string text;
    for (std::size_t k = 0; k < rle.counts.size(); ++k) {
        std::int64_t rest = rle.counts[k];
        if (k > 2) rest -= rle.counts[k - 2];
        for (bool more = true; more;) {
            const std::int64_t five = rest & 31;
            rest >>= 5;
            // The last group's highest bit is the sign.
            more = (five & 16) != 0 ? rest != -1 : rest != 0;
            text += char(48 + five + (more ? 32 : 0));
        }
    }
    return text;
}

} // namespace firsthit::cli
