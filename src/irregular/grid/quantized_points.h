// quantized_points.h - coordinates of a face quantized to 16 bits, so that x, y and w of a point
// fit into one word of 64 bits.
//
// The sample grid (sample_grid.h) tests samples against triangles with these words. An example,
// which tests/irregular/quantized_points_test.cpp checks. The samples of a parallel pencil have x,
// y and w from 0 to 1023.953125 = 65533 / 64, so each axis has start 0 and scale 64, and a
// coordinate v is quantized to 64 v + 1.
//
//     point          x, y, w          quantized        word: y x unused w, 16 bits each
//     corner a       1, 1, 4           65,  65, 257    0x 0041 0041 0000 0101
//     corner b       5, 1, 4          321,  65, 257    0x 0041 0141 0000 0101
//     corner c       1, 4, 2           65, 257, 129    0x 0101 0041 0000 0081
//     sample p       2, 2, 1          129, 129,  65    0x 0081 0081 0000 0041
//     sample q       4, 4, 1          257, 257,  65    0x 0101 0101 0000 0041
//     sample r       2, 2, 8          129, 129, 513    0x 0081 0081 0000 0201
//
// Box. The minimum and the maximum of each 16 bits of a, b and c are the triangle's box. The w of
// `low` is set to 0, because samples behind the whole triangle may be shadowed too:
//
//     low   0x 0041 0041 0000 0000        high   0x 0101 0141 0000 0101
//
// A sample may be shadowed only if clamping it to the box, max(min(sample, high), low), does not
// change it. So p and q may be, and r may not: its w, 513, is above 257, so it lies in front of the
// triangle. A word whose `unused` is not 0 is in no box.
//
// Edges. The normal of the edge from one corner to the next is (-dy, dx); it is stored in the 16
// bits of x and y, as signed numbers:
//
//     a to b (   0,  256)    b to c (-192, -256)    c to a ( 192,    0)
//
// Twice the triangle's area is the normal of a to b times (c - a) = 192 * 256 = 49152. It is
// positive; otherwise all normals would be negated. The box is 256 wide and 192 high, S = 448
// together, so quantizing changes an edge function by at most 2.5 S + 1 + 4 = 1125
// (SampleGrid::error_shift). An edge function is the normal times (sample - a), plus the error,
// plus twice the area for the edge opposite of a. A sample is certainly outside where one of the
// three is negative:
//
//                p: (sample - a) = (64, 64)                  q: (192, 192)
//     a to b     16384 + 1125 = 17509                        50277
//     b to c    -28672 + 1125 + 49152 = 21605               -35739
//     c to a     12288 + 1125 = 13413                        37989
//
// So p may be inside, and is decided in full precision (decide_pairs-inl.h); q is outside.
#pragma once

#include "irregular/mesh/cube_face.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>

namespace firsthit {

/// The largest quantized coordinate. Coordinates of samples are quantized to 1 to 65534; a
/// coordinate below those of all samples to 0, one above to 65535.
inline constexpr std::uint16_t kQuantizedMax = 65535;

/// How the coordinates and depths of a face are quantized. The function is monotonic and the same
/// for samples and triangles' corners, so a triangle's quantized box contains every sample of its
/// box, whatever the roundings.
struct GridAxes {
    struct Axis {
        float start = 0, scale = 0; // quantized = (v - start) * scale + 1, rounded
    };
    Axis x, y, w;
    bool transposed = false; // x and y of QuantizedPoint are exchanged
};

/// The quantized coordinates of a point; as a word of 64 bits, w is in the lowest 16. w is 65535
/// for a vertex that is behind the face or unusable.
struct alignas(8) QuantizedPoint {
    std::uint16_t w = 0, unused = 0, x = 0, y = 0;
};

/// Projects `count` vertices of the pencil's space to the face and quantizes them.
void quantize_vertices(const GridAxes& axes, const CubeFace& face, const glm::vec3* corner,
    std::size_t count, QuantizedPoint* quantized);

} // namespace firsthit
