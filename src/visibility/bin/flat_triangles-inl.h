// flat_triangles-inl.h - finds the texels of a shadow map that tiny triangles cover, one triangle a
// lane, from flat corners.
//
// Flat corners are (x/z, y/z, 1/z). They are moved so that the box's first texel is the origin.
// Then the edge from b to c at the texel that is i columns to the right and j rows down is
//
//     e = c + i gx + j gy,   c = b.x c.y - b.y c.x,  gx = b.y - c.y,  gy = c.x - b.x
//
// and 1/t is affine. Let u = 2^-24, mx and my the largest |x| and |y|, n the largest i or j. Then
// |computed e - e| <= 12 u R, where R = mx my + n (mx + my). A texel is certainly missed if, for
// the triangle's orientation, one edge is beyond E = 16 u R on the outside. The orientation is
// certain if the area is beyond 8 E; other triangles, which are seen nearly edge-on, stay open.
#if defined(FIRSTHIT_FLAT_TRIANGLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_FLAT_TRIANGLES_INL_H
#undef FIRSTHIT_FLAT_TRIANGLES_INL_H
#else
#define FIRSTHIT_FLAT_TRIANGLES_INL_H
#endif

#include <hwy/highway.h>

#include "visibility/bin/tiny_list-inl.h"
#include "visibility/bin/tiny_triangles-inl.h"

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// Does what cover_tiny does, for the texels of a shadow map: a texel is covered unless it is
/// certainly missed, and its depth lies between those of the corners. Does not write
/// found.triangle, which maps have no use for.
template <int kSide, class D>
HWY_INLINE std::uint32_t cover_flat(D d, const ListRegister& triangles, const LatticeTile& rays,
    const FragmentTarget& found, std::uint32_t at)
{
    TinyList& list = triangles.list;
    const int i = triangles.first;
    const hn::RebindToSigned<D> words;
    const hn::RebindToUnsigned<D> du;
    using V = hn::Vec<D>;
    const auto set = [&](float v) { return hn::Set(d, v); };
    const auto first = hn::Load(words, list.first + i), steps = hn::Load(words, list.steps + i);
    const auto low = [&](auto v) { return hn::And(v, hn::Set(words, 0xFFFF)); };
    const V sx = hn::Add(hn::ConvertTo(d, low(first)), set(rays.x0));
    const V sy = hn::Add(hn::ConvertTo(d, hn::ShiftRight<16>(first)), set(rays.y0));
    V x[3], y[3], w[3];
    for (int k = 0; k < 3; ++k) {
        x[k] = hn::Sub(hn::Load(d, list.corner[3 * k] + i), sx);
        y[k] = hn::Sub(hn::Load(d, list.corner[3 * k + 1] + i), sy);
        w[k] = hn::Load(d, list.corner[3 * k + 2] + i);
    }
    V c[3], gx[3], gy[3];
    for (int k = 0; k < 3; ++k) {
        const int p = (k + 1) % 3, q = (k + 2) % 3;
        c[k] = hn::Sub(hn::Mul(x[p], y[q]), hn::Mul(y[p], x[q]));
        gx[k] = hn::Sub(y[p], y[q]);
        gy[k] = hn::Sub(x[q], x[p]);
    }
    const V mx = hn::Max(hn::Abs(x[0]), hn::Max(hn::Abs(x[1]), hn::Abs(x[2])));
    const V my = hn::Max(hn::Abs(y[0]), hn::Max(hn::Abs(y[1]), hn::Abs(y[2])));
    const V across = hn::Mul(set(float(kSide - 1)), hn::Add(mx, my));
    const V reach = hn::Add(hn::Mul(mx, my), across);
    const V error = hn::Add(hn::Mul(reach, set(0x1p-20f)), set(0x1p-90f));

    // Find the plane of 1/t, starting at the first corner.
    const V area = hn::Add(hn::Add(c[0], c[1]), c[2]);
    const auto edge_on = hn::Le(hn::Abs(area), hn::Mul(error, set(8.0f)));
    const V inverse_area = hn::Div(set(1.0f), hn::IfThenElse(edge_on, set(1.0f), area));
    const V w1 = hn::Sub(w[1], w[0]), w2 = hn::Sub(w[2], w[0]);
    const auto slope = [&](const V(&e)[3]) {
        return hn::Mul(hn::Add(hn::Mul(e[1], w1), hn::Mul(e[2], w2)), inverse_area);
    };
    const V wx = slope(gx), wy = slope(gy);
    V row_w = hn::Add(w[0], slope(c));
    const V least_w = hn::Min(w[0], hn::Min(w[1], w[2]));
    const V most_w = hn::Max(w[0], hn::Max(w[1], w[2]));

    // Make edges positive inside, and add the bound of their error.
    V row[3];
    for (int k = 0; k < 3; ++k) {
        const auto inwards = [&](V v) { return hn::Xor(v, hn::And(area, set(-0.0f))); };
        row[k] = hn::Add(inwards(c[k]), error);
        gx[k] = inwards(gx[k]);
        gy[k] = inwards(gy[k]);
    }
    // Triangles that are edge-on have no known orientation, and stay open.
    const auto meant = hn::AndNot(edge_on, hn::FirstN(d, std::size_t(triangles.count)));
    hn::Mask<D> has_column[kSide];
    for (int k = 0; k < kSide; ++k)
        has_column[k] = hn::RebindMask(d, hn::Gt(low(steps), hn::Set(words, k - 1)));
    const auto place = hn::BitCast(du, first);
#pragma GCC unroll 4
    for (int j = 0; j < kSide; ++j) {
        const auto has_row = hn::And(
            meant, hn::RebindMask(d, hn::Gt(hn::ShiftRight<16>(steps), hn::Set(words, j - 1))));
        V e[3] = {row[0], row[1], row[2]}, depth = row_w;
#pragma GCC unroll 4
        for (int column = 0; column < kSide; ++column) {
            const auto inside = hn::Ge(hn::Min(e[0], hn::Min(e[1], e[2])), hn::Zero(d));
            const auto has = hn::And(has_column[column], has_row);
            const auto mask = hn::And(has, inside);
            const auto step = hn::Set(du, std::uint32_t(column + (j << 16)));
            const V nearest = hn::Min(hn::Max(depth, least_w), most_w);
            hn::StoreU(
                hn::Compress(hn::Add(place, step), hn::RebindMask(du, mask)), du, found.place + at);
            hn::StoreU(hn::Compress(nearest, mask), d, found.w + at);
            at += std::uint32_t(hn::CountTrue(d, mask));
            for (int k = 0; k < 3; ++k) e[k] = hn::Add(e[k], gx[k]);
            depth = hn::Add(depth, wx);
        }
        for (int k = 0; k < 3; ++k) row[k] = hn::Add(row[k], gy[k]);
        row_w = hn::Add(row_w, wy);
    }
    hn::Store(hn::IfThenElseZero(hn::RebindMask(du, edge_on), hn::Set(du, 1)), du, list.open + i);
    return at;
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif
