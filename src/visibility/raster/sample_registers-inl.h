// sample_registers-inl.h - SIMD registers whose lanes are samples of a tile, in the order of
// base/tile_order.h.
#if defined(FIRSTHIT_SAMPLE_REGISTERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SAMPLE_REGISTERS_INL_H
#undef FIRSTHIT_SAMPLE_REGISTERS_INL_H
#else
#define FIRSTHIT_SAMPLE_REGISTERS_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A register of 16 (a quad of 4x4), 8 (4x2), 4 (4x1), 2 or 1 samples.
using Samples = hn::CappedTag<float, 16>;
/// A register of as many samples as a register holds doubles.
using WideSamples = hn::Rebind<float, hn::CappedTag<double, 8>>;

/// Columns and rows of samples that a register covers.
template <class D>
constexpr int columns(D d)
{
    return std::min<int>(4, hn::MaxLanes(d));
}
template <class D>
constexpr int rows(D d)
{
    return std::max<int>(1, int(hn::MaxLanes(d)) / 4);
}

/// A bit for each lane of a mask.
template <class D>
HWY_INLINE std::uint64_t bits(D d, hn::Mask<D> mask)
{
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    std::uint64_t word;
    std::memcpy(&word, bytes, 8);
    return word;
}

/// The offset of each lane's sample from the register's first sample.
template <class D>
struct LaneOffsets {
    hn::Vec<D> x, y;
    explicit LaneOffsets(D d)
    {
        alignas(64) float lane_x[16], lane_y[16];
        for (int k = 0; k < 16; ++k) {
            lane_x[k] = float(k % columns(d));
            lane_y[k] = float(k / columns(d));
        }
        x = hn::Load(d, lane_x);
        y = hn::Load(d, lane_y);
    }
};

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif
