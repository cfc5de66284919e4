// run_lanes-inl.h - distributes the values of a block's runs to the samples of a register.
//
// The values of up to 16 runs fit into one or two registers, from which AVX-512 picks those of 8 or
// 16 samples with one instruction. Other instruction sets have no such instruction for so many
// values.
#if defined(FIRSTHIT_HITS_RUN_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_HITS_RUN_LANES_INL_H_
#undef FIRSTHIT_HITS_RUN_LANES_INL_H_
#else
#define FIRSTHIT_HITS_RUN_LANES_INL_H_
#endif

#include "hits/hit_tile.h"
#include "hits/item_runs-inl.h"

#include <span>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// The most runs of a block that RunLanes accepts; 0 where there is no RunLanes.
#if HWY_TARGET == HWY_AVX3
inline constexpr std::size_t kMostRunLanes = 16;
#else
inline constexpr std::size_t kMostRunLanes = 0;
#endif

#if HWY_TARGET == HWY_AVX3
/// The number among the block's runs of the run that each sample of a block is in; 0 for samples in
/// none.
class RunLanes {
  public:
    /// runs  all runs of one block, at most kMostRunLanes
    HWY_INLINE explicit RunLanes(std::span<const HitRun> runs)
    {
        __m512i number = _mm512_setzero_si512();
        for (std::size_t k = 1; k < runs.size(); ++k)
            number =
                _mm512_mask_mov_epi8(number, __mmask64(runs[k].samples), _mm512_set1_epi8(char(k)));
        _mm512_store_si512(number_, number);
    }

    /// Returns the values of the runs that the samples [first, first + 8) are in.
    ///
    /// value  of each run
    HWY_INLINE __m512d of_samples(int first, const double (&value)[kMostRunLanes]) const
    {
        const __m512i number = _mm512_cvtepu8_epi64(
            _mm_loadl_epi64(reinterpret_cast<const __m128i*>(number_ + first)));
        return _mm512_permutex2var_pd(_mm512_load_pd(value), number, _mm512_load_pd(value + 8));
    }

    /// The same for the samples [first, first + 16).
    HWY_INLINE __m512 of_samples(int first, __m512 value) const
    {
        const __m512i number =
            _mm512_cvtepu8_epi32(_mm_load_si128(reinterpret_cast<const __m128i*>(number_ + first)));
        return _mm512_permutexvar_ps(number, value);
    }

  private:
    alignas(64) std::uint8_t number_[kBlockSamples];
};
#endif

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
