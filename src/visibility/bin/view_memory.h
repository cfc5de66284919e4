// view_memory.h - a frame's triangles as one pencil sees them, kept from frame to frame.
#pragma once

#include "base/buffer.h"
#include "visibility/bin/tile_layout.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <span>

namespace firsthit {

/// Where a vertex stands among the samples, along x and y: 2 k + 1 on (or within rounding of) sample
/// k, 2 k between the samples k - 1 and k, in [0, 2 width]. So a triangle's samples follow from the
/// least and the most of its corners'. These are the bits of a corner's fourth coordinate.
struct VertexSamples {
    std::int16_t x, y;

    /// In x: the vertex has no projection, its triangles take the careful way.
    static constexpr std::int16_t kBehind = -32768;

    static constexpr int first(int least) { return least >> 1; }
    static constexpr int last(int most) { return ((most + 1) >> 1) - 1; }
};
static_assert(sizeof(VertexSamples) == sizeof(float));

/// What corners are.
enum class CornerSpace {
    eye,  // (x, y, z) in eye space
    flat, // (x/z, y/z, 1/z), as shadow maps want them; kBehind: (x, y, z)
};

/// A triangle that may hit a sample: its samples, ends included. 16 bytes.
struct InView {
    std::uint32_t triangle;
    std::int16_t x0, y0, x1, y1;
    float nearest_z; // of its corners, not more; 0 or less: it reaches behind the eye
};

/// A triangle in a tile: its samples inside the tile, ends included. 12 bytes.
struct TileEntry {
    std::uint32_t triangle;
    std::uint8_t x0, y0, x1, y1;
    float nearest_z;
};

/// A sample that a tiny triangle covers for certain. 12 bytes.
struct Fragment {
    std::uint32_t place; // tile << 16 | offset in the tile, see tile_order.h
    std::uint32_t triangle;
    float w; // 1/t
};

/// A texel that a tiny triangle covers. 8 bytes.
struct DepthFragment {
    std::uint32_t place; // as of Fragment
    float w;
};

/// Fragments in the order in which they are found, structure of arrays.
struct FoundFragments {
    Buffer<std::uint32_t, Pages::small> place;
    Buffer<std::uint32_t, Pages::small> triangle; // not of flat corners
    Buffer<float, Pages::small> w;

    void resize(std::size_t count)
    {
        place.resize(count);
        triangle.resize(count);
        w.resize(count);
    }
};

/// What a range of triangles found.
struct RangeCount {
    std::uint32_t in_view;   // to be sorted into tiles
    std::uint32_t tiny;      // done with: what they cover is among the fragments
    std::uint32_t fragments; // of those
};

/// The triangles as a pencil sees them.
struct EyeMesh {
    std::span<const glm::uvec3> index;
    CornerSpace corner_space = CornerSpace::eye;
    Buffer<glm::vec4> corner; // (V) see Pencil; VertexSamples
};

/// The triangles that may hit a sample, by tile.
struct Bins {
    // (T) room; each range of triangles fills the start of its part
    Buffer<InView, Pages::small> in_view;
    Buffer<TileEntry> entry;          // (entries) by tile, then by triangle
    Buffer<std::uint32_t> tile_start; // (tiles + 1) into entry
    Buffer<RangeCount> range_count;   // (ranges)
    Buffer<std::uint32_t> cursor;     // (ranges, tiles)

    std::uint32_t found_room = 0; // fragments for which a range has room
    FoundFragments found;         // (ranges, room); each range fills the start of its part
    // (fragments) by tile, then by range; the second of flat corners
    Buffer<Fragment> fragment;
    Buffer<DepthFragment> depth_fragment;
    Buffer<std::uint32_t> fragment_start;  // (tiles + 1) into these
    Buffer<std::uint32_t> fragment_cursor; // (ranges, tiles)

    std::uint64_t in_view_count = 0; // triangles that may hit a sample
    std::uint64_t entry_count = 0;
};

/// What an engine keeps of one pencil. Functions take the part of it that they need.
struct ViewMemory : TileLayout, EyeMesh, Bins {};

} // namespace firsthit
