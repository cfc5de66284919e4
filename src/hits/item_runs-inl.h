// item_runs-inl.h - finds the samples of a block that see the same triangle.
#if defined(FIRSTHIT_HITS_ITEM_RUNS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_HITS_ITEM_RUNS_INL_H_
#undef FIRSTHIT_HITS_ITEM_RUNS_INL_H_
#else
#define FIRSTHIT_HITS_ITEM_RUNS_INL_H_
#endif

#include <hwy/highway.h>

#include "base/tile_order.h"

#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A bit for each lane of a mask, at most 64.
template <class D, class M>
HWY_INLINE std::uint64_t bits_of(D d, M mask)
{
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    std::uint64_t word;
    std::memcpy(&word, bytes, 8);
    return word;
}

/// A bit for each sample of a block whose item is `id`.
///
/// items  (64) of the block, aligned to 64 bytes
HWY_INLINE std::uint64_t samples_with(const std::uint32_t* items, std::uint32_t id)
{
    const hn::CappedTag<std::uint32_t, 16> d;
    const auto wanted = hn::Set(d, id);
    std::uint64_t samples = 0;
    for (int k = 0; k < kBlockSamples; k += int(hn::Lanes(d)))
        samples |= bits_of(d, hn::Eq(hn::Load(d, items + k), wanted)) << k;
    return samples;
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
