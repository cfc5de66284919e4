// quantized_points-inl.h - quantizes coordinates to 16 bits (quantized_points.h).
#if defined(FIRSTHIT_IRREGULAR_GRID_QUANTIZED_POINTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_IRREGULAR_GRID_QUANTIZED_POINTS_INL_H_
#undef FIRSTHIT_IRREGULAR_GRID_QUANTIZED_POINTS_INL_H_
#else
#define FIRSTHIT_IRREGULAR_GRID_QUANTIZED_POINTS_INL_H_
#endif

#include <hwy/highway.h>

#include "irregular/grid/quantized_points.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Quantizes a register of coordinates. The results are 32 bits wide and at most `last`.
template <class V>
HWY_INLINE auto quantize(const GridAxes::Axis& axis, float last, V v)
{
    const hn::DFromV<V> d;
    const hn::RebindToSigned<decltype(d)> whole;
    const V one = hn::Set(d, 1.0f), zero = hn::Zero(d);
    const V at = hn::Add(hn::Mul(hn::Sub(v, hn::Set(d, axis.start)), hn::Set(d, axis.scale)), one);
    // NaN comes from an infinite coordinate on an axis with scale 0: all its samples have 1.
    const V inside = hn::IfThenElse(
        hn::Eq(at, at), hn::IfThenElse(hn::Gt(at, zero), hn::Min(at, hn::Set(d, last)), zero), one);
    // Adding 2^23 rounds to the nearest whole number, and leaves it in the lowest bits.
    const V shifted = hn::Add(inside, hn::Set(d, 8388608.0f));
    return hn::And(hn::BitCast(whole, shifted), hn::Set(whole, 0xFFFF));
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
