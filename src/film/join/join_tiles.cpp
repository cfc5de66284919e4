// join_tiles.cpp - puts tiles of a picture together.
#include "film/join/raw_picture.h"

#include <firsthit/error.h>
#include <firsthit/join.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>

namespace firsthit {
namespace {

using ReadRaw = RawPicture (*)(const std::string& path, const glm::ivec2& size);

std::string ending_of(const std::string& path)
{
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
        [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return ending;
}

ReadRaw reader_of(const std::string& path)
{
    const std::string ending = ending_of(path);
    if (ending == ".png") return read_raw_png;
    if (ending == ".exr") return read_raw_exr;
    if (ending == ".npy") return read_raw_npy;
    throw ArgumentError(fmt::format(
        "{}: accepted tiles are .png, .exr and .npy, which hold their pixels without loss", path));
}

std::string region_text(const Region& region)
{
    return fmt::format("{},{},{},{}", region.x, region.y, region.width, region.height);
}

/// The size of the picture that the tiles reach to.
glm::ivec2 whole_size(std::span<const PictureTile> tiles)
{
    constexpr int kMostSide = 65536; // as View
    glm::ivec2 size(0);
    for (const PictureTile& tile : tiles) {
        const Region& region = tile.region;
        if (region.x < 0 || region.y < 0 || region.width < 1 || region.height < 1 ||
            region.x > kMostSide - region.width || region.y > kMostSide - region.height)
            throw ArgumentError(fmt::format("{}: region {} is not in a picture of at most {}x{}",
                tile.path, region_text(region), kMostSide, kMostSide));
        size.x = std::max(size.x, region.x + region.width);
        size.y = std::max(size.y, region.y + region.height);
    }
    return size;
}

/// Whether the tiles of a row of pixels, from left to right, touch one another and both sides.
void check_row(int y, std::span<const PictureTile* const> row, int width)
{
    int x = 0;
    const auto gap = [&] {
        throw ArgumentError(fmt::format("no tile has pixel ({}, {}) of the picture", x, y));
    };
    for (std::size_t k = 0; k < row.size(); ++k) {
        const Region& region = row[k]->region;
        if (region.x > x) gap();
        if (region.x < x)
            throw ArgumentError(fmt::format("{} ({}) and {} ({}) both have pixel ({}, {})",
                row[k - 1]->path, region_text(row[k - 1]->region), row[k]->path,
                region_text(region), region.x, y));
        x = region.x + region.width;
    }
    if (x < width) gap();
}

/// Each pixel belongs to one tile. Rows between two edges of tiles are alike, so that one of them tells.
void check_cover(std::span<const PictureTile> tiles, const glm::ivec2& size)
{
    std::vector<int> edges{0};
    for (const PictureTile& tile : tiles) {
        edges.push_back(tile.region.y);
        edges.push_back(tile.region.y + tile.region.height);
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::vector<const PictureTile*> row;
    for (const int y : edges) {
        if (y >= size.y) break;
        row.clear();
        for (const PictureTile& tile : tiles)
            if (tile.region.y <= y && y < tile.region.y + tile.region.height) row.push_back(&tile);
        std::stable_sort(row.begin(), row.end(),
            [](const PictureTile* a, const PictureTile* b) { return a->region.x < b->region.x; });
        check_row(y, row, size.x);
    }
}

void copy_into(const RawPicture& tile, const Region& region, RawPicture& whole)
{
    const std::size_t row_bytes = tile.pixel_bytes * static_cast<std::size_t>(tile.width);
    for (int y = 0; y < tile.height; ++y) {
        const std::size_t pixel =
            static_cast<std::size_t>(region.y + y) * static_cast<std::size_t>(whole.width) +
            static_cast<std::size_t>(region.x);
        std::copy_n(tile.bytes.data() + static_cast<std::size_t>(y) * row_bytes, row_bytes,
            whole.bytes.data() + pixel * whole.pixel_bytes);
    }
}

} // namespace

void join_tiles(std::span<const PictureTile> tiles, const std::string& output)
{
    if (tiles.empty()) throw ArgumentError("no tiles to join");
    const ReadRaw read = reader_of(tiles[0].path);
    for (const PictureTile& tile : tiles)
        if (reader_of(tile.path) != read)
            throw ArgumentError(
                fmt::format("{} and {} are files of different kinds", tiles[0].path, tile.path));
    if (ending_of(output) != ending_of(tiles[0].path))
        throw ArgumentError(
            fmt::format("{}: accepted is the tiles' ending, {}", output, ending_of(tiles[0].path)));
    const glm::ivec2 size = whole_size(tiles);
    check_cover(tiles, size);

    RawPicture whole;
    for (const PictureTile& tile : tiles) {
        const RawPicture part = read(tile.path, {tile.region.width, tile.region.height});
        if (whole.bytes.empty()) {
            whole.kind = part.kind;
            whole.width = size.x;
            whole.height = size.y;
            whole.pixel_bytes = part.pixel_bytes;
            whole.bytes.resize(std::size_t(size.x) * std::size_t(size.y) * part.pixel_bytes);
        }
        if (part.kind != whole.kind)
            throw FileError(fmt::format("{}: is {}, and {} is {}", tile.path, kind_text(part.kind),
                tiles[0].path, kind_text(whole.kind)));
        copy_into(part, tile.region, whole);
    }
    write_raw_picture(whole, output);
}

} // namespace firsthit
