// tiny_triangles-inl.h - triangles whose box has few samples: one a lane, from corners to covered
// samples without a word about tiles.
//
// Corners are moved along z to the first sample's ray: a = (x - X z, y - Y z), exact but for one
// rounding, since X and Y have few bits. There d = (0, 0, 1), and the edge from b to c over the
// sample i to the right and j down is
//
//     e = c + i gx + j gy,   c = b.x c.y - b.y c.x,  gx = b.y c.z - b.z c.y,  gy = b.z c.x - b.x c.z
//
// Let u = 2^-24, mx and my the largest |x| and |y|, Z the largest z, n the largest i or j. Products
// have an error of 3 u, their difference of 4 u, i gx one more, the two sums 2 u: |computed e - e| <=
// 12 u R, R = mx my + n Z (mx + my). Where all three are beyond 16 u R = E on one side, the sample
// is hit, since the volume is the sum of the edges times the opposite corners' z; where one is beyond
// E and one beyond -E, it is missed.
//
// With S the sum of edges, 1/t = S / sum(e z): the weights e / S are wrong by at most 4.5 E / |S|
// together, and the depth by that times the triangle's extent in z; six more roundings. All is below
// kDepthError = 24 u where 5 R (Z - least z) <= (|S| - 3 E) least z.
//
// Depths within [2^-30, 2^30] keep products far from overflow; what underflow or flushing takes
// away is less than 2^-90.
#if defined(FIRSTHIT_TINY_TRIANGLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_TINY_TRIANGLES_INL_H
#undef FIRSTHIT_TINY_TRIANGLES_INL_H
#else
#define FIRSTHIT_TINY_TRIANGLES_INL_H
#endif

#include <hwy/highway.h>

#include "visibility/bin/tiny_list-inl.h"

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Where covered samples are written: a register at a time, so beyond the last.
struct FragmentTarget {
    std::uint32_t* place; // x | y << 16
    std::uint32_t* triangle;
    float* w;
};

/// Sums may be fused with products, since the bound is all that counts.
#if HWY_NATIVE_FMA
constexpr bool kFuses = true;
using TinyItems = hn::CappedTag<float, 16>;
#else
constexpr bool kFuses = false;
using TinyItems = hn::Rebind<float, hn::CappedTag<double, 8>>;
#endif

/// x - s z, s with at most 24 bits, rounded once (or from double).
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

/// One register of the list, starting with number i, of which `count` lanes are meant. Appends the
/// covered samples to `found`, and says which triangles are open.
///
/// kSide  of the boxes, at most
/// x0, y0  direction of the pencil's first sample
/// returns  the number of fragments found, with those before
template <int kSide, class D>
HWY_INLINE std::uint32_t cover_tiny(D d, TinyList& list, int i, int count, float x0, float y0,
    const FragmentTarget& found, std::uint32_t at)
{
    constexpr int kSamples = kSide * kSide;
    const hn::RebindToSigned<D> w;
    const hn::RebindToUnsigned<D> du;
    using V = hn::Vec<D>;
    const auto set = [&](float v) { return hn::Set(d, v); };
    V x[3], y[3], z[3];
    const auto first = hn::Load(w, list.first + i), steps = hn::Load(w, list.steps + i);
    const auto low = [&](auto v) { return hn::And(v, hn::Set(w, 0xFFFF)); };
    const V sx = hn::Add(hn::ConvertTo(d, low(first)), set(x0));
    const V sy = hn::Add(hn::ConvertTo(d, hn::ShiftRight<16>(first)), set(y0));
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
    const auto meant = hn::FirstN(d, std::size_t(count));
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
