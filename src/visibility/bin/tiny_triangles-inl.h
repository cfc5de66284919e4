// tiny_triangles-inl.h - finds the samples that tiny triangles cover, one triangle a lane. A tiny
// triangle is one whose box has few samples. Tiles play no part here.
//
// Corners are moved along z so that the ray of the box's first sample (X, Y, 1) becomes the z axis:
// a = (x - X z, y - Y z) is exact but for one rounding, since X and Y have few bits. Then the edge
// from b to c at the sample that is i columns to the right and j rows down is
//
//     e = c + i gx + j gy,   c = b.x c.y - b.y c.x,  gx = b.y c.z - b.z c.y,  gy = b.z c.x - b.x c.z
//
// Let u = 2^-24, mx and my the largest |x| and |y|, Z the largest z, n the largest i or j. Products
// have an error of 3 u, their difference of 4 u, i gx one more, the two sums 2 u. So |computed e -
// e| <= 12 u R, where R = mx my + n Z (mx + my). If all three edges are beyond E = 16 u R on one
// side, the ray hits, since the volume is the sum of the edges times the opposite corners' z. If
// one edge is beyond E and another one beyond -E, it misses.
//
// Let S be the sum of the edges; 1/t = S / sum(e z). The weights e / S have an error of at most
// 4.5 E / |S| together, and the depth has an error of that times the triangle's extent in z, and six
// more roundings. All together is below kDepthError = 24 u if 5 R (Z - least z) <= (|S| - 3 E)
// least z.
//
// Depths in [2^-30, 2^30] keep products far from overflow. Underflow, and flushing it to 0, change
// a result by less than 2^-90.
#if defined(FIRSTHIT_TINY_TRIANGLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_TINY_TRIANGLES_INL_H
#undef FIRSTHIT_TINY_TRIANGLES_INL_H
#else
#define FIRSTHIT_TINY_TRIANGLES_INL_H
#endif

#include <hwy/highway.h>

#include "exact/pencil.h"
#include "visibility/bin/tiny_list-inl.h"

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Where covered samples are written. Whole registers are written, also beyond the last sample.
struct FragmentTarget {
    std::uint32_t* place; // the sample, x | y << 16
    std::uint32_t* triangle;
    float* w; // 1/t
};

/// Products and sums may be fused, since results are only compared with error bounds.
#if HWY_NATIVE_FMA
constexpr bool kFuses = true;
using TinyItems = hn::CappedTag<float, 16>;
#else
constexpr bool kFuses = false;
using TinyItems = hn::Rebind<float, hn::CappedTag<double, 8>>;
#endif

/// x - s z, rounded once, or from double. s is a float.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V shear(D, V x, V s, V z)
{
    if constexpr (kFuses) {
        return hn::NegMulAdd(s, z, x);
    } else {
        const D d;
        const hn::Rebind<double, D> wide;
        return hn::DemoteTo(d, hn::Sub(hn::PromoteTo(wide, x),
                                   hn::Mul(hn::PromoteTo(wide, s), hn::PromoteTo(wide, z))));
    }
}

/// p q - r s
template <class V>
HWY_INLINE V determinant(V p, V q, V r, V s)
{
    if constexpr (kFuses)
        return hn::NegMulAdd(r, s, hn::Mul(p, q));
    else
        return hn::Sub(hn::Mul(p, q), hn::Mul(r, s));
}

/// Finds the samples that the triangles of a register cover, and appends them to `found`. Sets
/// `open` of the triangles for which this is not certain; nothing is appended for those.
///
/// kSide    samples on a side of the boxes, at most
/// rays     of the pencil
/// at       number of the fragments that `found` holds already
/// returns  their number afterwards
template <int kSide, class D>
HWY_INLINE std::uint32_t cover_tiny(D d, const ListRegister& triangles, const LatticeTile& rays,
    const FragmentTarget& found, std::uint32_t at)
{
    TinyList& list = triangles.list;
    const int i = triangles.first;
    constexpr int kSamples = kSide * kSide;
    const hn::RebindToSigned<D> w;
    const hn::RebindToUnsigned<D> du;
    using V = hn::Vec<D>;
    const auto set = [&](float v) { return hn::Set(d, v); };
    V x[3], y[3], z[3];
    const auto first = hn::Load(w, list.first + i), steps = hn::Load(w, list.steps + i);
    const auto low = [&](auto v) { return hn::And(v, hn::Set(w, 0xFFFF)); };
    const V sx = hn::Add(hn::ConvertTo(d, low(first)), set(rays.x0));
    const V sy = hn::Add(hn::ConvertTo(d, hn::ShiftRight<16>(first)), set(rays.y0));
    for (int k = 0; k < 3; ++k) {
        z[k] = hn::Load(d, list.corner[3 * k + 2] + i);
        x[k] = shear(d, hn::Load(d, list.corner[3 * k] + i), sx, z[k]);
        y[k] = shear(d, hn::Load(d, list.corner[3 * k + 1] + i), sy, z[k]);
    }

    V c[3], gx[3], gy[3];
    for (int k = 0; k < 3; ++k) {
        const int p = (k + 1) % 3, q = (k + 2) % 3;
        c[k] = determinant(x[p], y[q], y[p], x[q]);
        gx[k] = determinant(y[p], z[q], z[p], y[q]);
        gy[k] = determinant(z[p], x[q], x[p], z[q]);
    }
    const V mx = hn::Max(hn::Abs(x[0]), hn::Max(hn::Abs(x[1]), hn::Abs(x[2])));
    const V my = hn::Max(hn::Abs(y[0]), hn::Max(hn::Abs(y[1]), hn::Abs(y[2])));
    const V nearest = hn::Min(z[0], hn::Min(z[1], z[2]));
    const V farthest = hn::Max(z[0], hn::Max(z[1], z[2]));
    const V across = hn::Mul(hn::Mul(farthest, set(float(kSide - 1))), hn::Add(mx, my));
    const V reach = hn::Add(hn::Mul(mx, my), across);
    const V error = hn::Add(hn::Mul(reach, set(0x1p-20f)), set(0x1p-90f));
    const V minus_error = hn::Neg(error);
    const V depth_error = hn::Mul(hn::Mul(reach, set(5.0f)), hn::Sub(farthest, nearest));

    auto open = hn::Or(hn::Lt(nearest, set(0x1p-30f)), hn::Gt(farthest, set(0x1p30f)));
    const auto meant = hn::FirstN(d, std::size_t(triangles.count));
    hn::Mask<D> has_column[kSide], has_row[kSide];
    for (int k = 0; k < kSide; ++k) {
        const auto before = hn::Set(w, k - 1);
        has_column[k] = hn::RebindMask(d, hn::Gt(low(steps), before));
        has_row[k] = hn::And(meant, hn::RebindMask(d, hn::Gt(hn::ShiftRight<16>(steps), before)));
    }
    hn::Mask<D> covered[kSamples];
    V depth[kSamples];
#pragma GCC unroll 16
    for (int k = 0; k < kSamples; ++k) {
        const int column = k % kSide, row = k / kSide;
        const auto has = hn::And(has_column[column], has_row[row]);
        V e[3];
        for (int edge = 0; edge < 3; ++edge) {
            e[edge] = c[edge];
            const auto step = [&](V g, int n) {
                if (n == 1) e[edge] = hn::Add(e[edge], g);
                if (n > 1) e[edge] = hn::Add(e[edge], hn::Mul(g, set(float(n))));
            };
            step(gx[edge], column);
            step(gy[edge], row);
        }
        const V least = hn::Min(e[0], hn::Min(e[1], e[2]));
        const V most = hn::Max(e[0], hn::Max(e[1], e[2]));
        const auto missed = hn::And(hn::Lt(least, minus_error), hn::Gt(most, error));
        const V sum = hn::Add(hn::Add(e[0], e[1]), e[2]);
        const V volume =
            hn::Add(hn::Add(hn::Mul(e[0], z[0]), hn::Mul(e[1], z[1])), hn::Mul(e[2], z[2]));
        depth[k] = hn::Div(sum, volume);
        const auto hit = hn::Or(hn::Gt(least, error), hn::Lt(most, minus_error));
        const V rest = hn::Sub(hn::Abs(sum), hn::Mul(error, set(3.0f)));
        const auto certain = hn::And(hit, hn::Le(depth_error, hn::Mul(rest, nearest)));
        covered[k] = hn::And(has, certain);
        open = hn::Or(open, hn::AndNot(hn::Or(certain, missed), has));
    }
    hn::Store(hn::IfThenElseZero(hn::RebindMask(du, open), hn::Set(du, 1)), du, list.open + i);

    const auto triangle = hn::Load(du, list.triangle + i);
    const auto place = hn::BitCast(du, first);
#pragma GCC unroll 16
    for (int k = 0; k < kSamples; ++k) {
        const auto mask = hn::AndNot(open, covered[k]);
        const auto whole = hn::RebindMask(du, mask);
        const auto step = hn::Set(du, std::uint32_t(k % kSide + (k / kSide << 16)));
        hn::StoreU(hn::Compress(hn::Add(place, step), whole), du, found.place + at);
        hn::StoreU(hn::Compress(triangle, whole), du, found.triangle + at);
        hn::StoreU(hn::Compress(depth[k], mask), d, found.w + at);
        at += std::uint32_t(hn::CountTrue(d, mask));
    }
    return at;
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif
