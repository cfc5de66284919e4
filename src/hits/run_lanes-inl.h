// run_lanes-inl.h - what is known of a block's runs, brought to the samples of a register.
//
// Of up to 16 runs the values lie in one or two registers, out of which AVX-512 picks those of 8 or 16
// samples in one instruction. Other instruction sets have no such thing for so many values.
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

/// Runs of a block at most, for which there is RunLanes; 0: there is none.
#if HWY_TARGET == HWY_AVX3
inline constexpr std::size_t kMostRunLanes = 16;
#else
inline constexpr std::size_t kMostRunLanes = 0;
#endif

#if HWY_TARGET == HWY_AVX3
/// The run of each sample of a block, by its number among the block's. Samples without one have 0.
class RunLanes {
  public:
    /// runs  of one block, at most kMostRunLanes
    HWY_INLINE explicit RunLanes(std::span<const HitRun> runs)
    {
        __m512i number = _mm512_setzero_si512();
        for (std::size_t k = 1; k < runs.size(); ++k)
            number =
                _mm512_mask_mov_epi8(number, __mmask64(runs[k].samples), _mm512_set1_epi8(char(k)));
        _mm512_store_si512(number_, number);
    }

    /// From a value for each run to those of the samples [first, first + 8).
    HWY_INLINE __m512d of_samples(int first, const double (&value)[kMostRunLanes]) const
    {
        const __m512i number = _mm512_cvtepu8_epi64(
            _mm_loadl_epi64(reinterpret_cast<const __m128i*>(number_ + first)));
        return _mm512_permutex2var_pd(_mm512_load_pd(value), number, _mm512_load_pd(value + 8));
    }

    /// Of the samples [first, first + 16).
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
