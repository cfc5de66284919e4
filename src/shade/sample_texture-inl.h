// sample_texture-inl.h - the texture's colour for the samples of a block, trilinear.
#if defined(FIRSTHIT_SHADE_SAMPLE_TEXTURE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SHADE_SAMPLE_TEXTURE_INL_H_
#undef FIRSTHIT_SHADE_SAMPLE_TEXTURE_INL_H_
#else
#define FIRSTHIT_SHADE_SAMPLE_TEXTURE_INL_H_
#endif

#include "shade/block_surface-inl.h"

#include <firsthit/texture.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// a where `choose_a` in its lanes, else b.
FIRSTHIT_PURE real3 select3(truth choose_a, real3 a, real3 b)
{
    return real3(mix(b.x, a.x, choose_a), mix(b.y, a.y, choose_a), mix(b.z, a.z, choose_a));
}

/// Where in the texture's texels each lane's level begins.
FIRSTHIT_PURE integer first_texel(const Texture& texture, integer level)
{
    const std::int32_t* first = texture.first().data();
#if HWY_TARGET == HWY_AVX3
    static_assert(Texture::kMaxLevels == kLanes);
    const IntegerTag d;
    return integer(hn::TableLookupLanes(hn::LoadU(d, first), hn::IndicesFromVec(d, level.lanes)));
#else
    return integer(hn::GatherIndex(IntegerTag(), first, level.lanes));
#endif
}

/// Which texels the samples of a block see, and how much each counts. Only registers with chosen
/// samples are defined.
struct BlockTexels {
    /// Of two neighbours, the left and the right one.
    struct alignas(64) Pairs {
        std::int32_t left[kBlockSamples];    // index; the right one is next
        std::int32_t weights[kBlockSamples]; // the right one's times 2^16, plus the left one's
    };
    struct Level {
        Pairs top, bottom;
    };
    Level finer, coarser;
    std::uint64_t blended; // samples for which the coarser level counts
};

/// Where the samples of a block are in a texture, which levels they see, and how much each counts.
struct alignas(64) BlockPlaces {
    float right[kBlockSamples]; // from the left edge, 0 to 1
    float down[kBlockSamples];  // from the top edge, 0 to 1
    float finer[kBlockSamples];
    std::int32_t coarser_weight[kBlockSamples]; // of whole_weight()
};

/// Each sample has two levels of its own. Returns those for which the coarser one counts: none where
/// texels are enlarged.
HWY_INLINE std::uint64_t find_places(
    const Texture& texture, const BlockSurface& surface, std::uint64_t samples, BlockPlaces& places)
{
    const real last(static_cast<float>(texture.levels() - 1));
    std::uint64_t blended = 0;
    for (int first = 0; first < kBlockSamples; first += kLanes) {
        if (lane_bits(samples, first) == 0) continue;
        const real level = mip_level(load(surface.footprint2 + first), last);
        const real finer = floor(level);
        const real rest = level - finer;
        store(finer, places.finer + first);
        store(repeat(load(surface.uv[0] + first)), places.right + first);
        store(1.0f - repeat(load(surface.uv[1] + first)), places.down + first);
        hn::Store(
            whole_to_integer(rest * 32767.0f).lanes, IntegerTag(), places.coarser_weight + first);
        blended |= bits_of_truth(rest > real(0.0f)) << first;
    }
    return blended & samples;
}

/// Finds the texels of the finer or the coarser levels.
template <bool coarser>
HWY_INLINE void find_texels(const Texture& texture, const BlockPlaces& places,
    std::uint64_t samples, BlockTexels::Level& texels)
{
    const real width(static_cast<float>(texture.width()));
    const real height(static_cast<float>(texture.height()));
    const real last(static_cast<float>(texture.levels() - 1));
    const IntegerTag d;
    for (int first = 0; first < kBlockSamples; first += kLanes) {
        if (lane_bits(samples, first) == 0) continue;
        const real right = load(places.right + first);
        const real down = load(places.down + first);
        real level = load(places.finer + first);
        integer weight(hn::Load(d, places.coarser_weight + first));
        if (coarser)
            level = min(level + 1.0f, last);
        else
            weight = whole_weight() - weight;

        const Texels at =
            bilinear_texels(right, down, level_size(width, level), level_size(height, level));
        const TexelWeights weights = texel_weights(at, weight);
        const integer begin = first_texel(texture, whole_to_integer(level));
        const auto keep = [&](integer index, integer left, integer right_weight,
                              BlockTexels::Pairs& pairs) {
            hn::Store((index + begin).lanes, d, pairs.left + first);
            hn::Store(hn::Add(left.lanes, hn::ShiftLeft<16>(right_weight.lanes)), d,
                pairs.weights + first);
        };
        keep(at.top, weights.top_left, weights.top_right, texels.top);
        keep(at.bottom, weights.bottom_left, weights.bottom_right, texels.bottom);
    }
}

#if HWY_TARGET == HWY_SCALAR || !HWY_ARCH_X86

/// Sums of weighted texels of a register of samples, while pairs are added.
class WeightedTexels {
  public:
    /// texel  the texture's
    void add(const Texel* texel, const BlockTexels::Pairs& pairs, int first)
    {
        for (int lane = 0; lane < kLanes; ++lane) {
            const Texel* const left = texel + pairs.left[first + lane];
            const std::int32_t weights = pairs.weights[first + lane];
            for (std::size_t c = 0; c < 3; ++c)
                sum_[c][lane] += (weights & 0xFFFF) * left[0][c] + (weights >> 16) * left[1][c];
        }
    }

    real3 light() const
    {
        const auto channel = [&](int c) {
            return texel_light(integer(hn::Load(IntegerTag(), sum_[c])));
        };
        return real3(channel(0), channel(1), channel(2));
    }

  private:
    alignas(64) std::int32_t sum_[3][kLanes] = {};
};

#else

/// Sums of weighted texels of a register of samples, while pairs are added.
///
/// Two neighbours are 16 bytes, one load. A register holds those of every fourth sample: of samples
/// 0, 4, 8 and 12 in one of 16, and so on. After their channels are put side by side, an instruction
/// multiplies both texels with their weights and adds the two; the sums are transposed in the end.
class WeightedTexels {
  public:
    HWY_INLINE WeightedTexels()
    {
        for (Sum& sum : sum_) sum = hn::Zero(IntegerTag());
    }

    /// texel  the texture's
    HWY_INLINE void add(const Texel* texel, const BlockTexels::Pairs& pairs, int first)
    {
        const IntegerTag d;
        const std::int32_t* index = pairs.left + first;
        const Sum weights = hn::Load(d, pairs.weights + first);
        sum_[0] = add_samples<0>(texel, index, weights, sum_[0]);
        sum_[1] = add_samples<1>(texel, index, weights, sum_[1]);
        sum_[2] = add_samples<2>(texel, index, weights, sum_[2]);
        sum_[3] = add_samples<3>(texel, index, weights, sum_[3]);
    }

    HWY_INLINE real3 light() const
    {
        const IntegerTag d;
        const auto red_green_02 = hn::InterleaveLower(d, sum_[0], sum_[2]);
        const auto red_green_13 = hn::InterleaveLower(d, sum_[1], sum_[3]);
        const auto blue_02 = hn::InterleaveUpper(d, sum_[0], sum_[2]);
        const auto blue_13 = hn::InterleaveUpper(d, sum_[1], sum_[3]);
        return real3(texel_light(integer(hn::InterleaveLower(d, red_green_02, red_green_13))),
            texel_light(integer(hn::InterleaveUpper(d, red_green_02, red_green_13))),
            texel_light(integer(hn::InterleaveLower(d, blue_02, blue_13))));
    }

  private:
    using Sum = hn::Vec<IntegerTag>;

    /// Two texels from each fourth index on.
    static HWY_INLINE auto load_pairs(const Texel* texel, const std::int32_t* index)
    {
        const auto pair = [&](int lane) {
            return hn::LoadU(hn::Full128<std::int16_t>(), texel[index[lane]].data());
        };
#if HWY_TARGET == HWY_AVX3
        const hn::Full256<std::int16_t> half;
        return hn::Combine(hn::Full512<std::int16_t>(), hn::Combine(half, pair(12), pair(8)),
            hn::Combine(half, pair(4), pair(0)));
#elif HWY_TARGET == HWY_AVX2
        return hn::Combine(hn::Full256<std::int16_t>(), pair(4), pair(0));
#else
        return pair(0);
#endif
    }

    /// Of samples k, k + 4, ...
    template <int k>
    static HWY_INLINE Sum add_samples(
        const Texel* texel, const std::int32_t* index, Sum weights, Sum sum)
    {
        const hn::ScalableTag<std::int16_t> d;
        alignas(16) static constexpr std::uint8_t kSideBySide[] = {
            0, 1, 8, 9, 2, 3, 10, 11, 4, 5, 12, 13, 6, 7, 14, 15};
        const hn::Repartition<std::uint8_t, decltype(d)> bytes;
        const auto pairs = hn::TableLookupBytes(
            load_pairs(texel, index + k), hn::BitCast(d, hn::LoadDup128(bytes, kSideBySide)));
        Sum none = hn::Zero(IntegerTag()); // x86 leaves it so
        return hn::ReorderWidenMulAccumulate(
            IntegerTag(), pairs, hn::BitCast(d, hn::Broadcast<k>(weights)), sum, none);
    }

    Sum sum_[4];
};

#endif

/// Writes the light of chosen samples, and any to others of their registers.
HWY_NOINLINE void weigh_texels(const Texture& texture, const BlockTexels& texels,
    std::uint64_t samples, float (&light)[3][kBlockSamples])
{
    const Texel* const texel = texture.texels().data();
    for (int first = 0; first < kBlockSamples; first += kLanes) {
        if (lane_bits(samples, first) == 0) continue;
        WeightedTexels sums;
        sums.add(texel, texels.finer.top, first);
        sums.add(texel, texels.finer.bottom, first);
        if (lane_bits(texels.blended, first) != 0) {
            sums.add(texel, texels.coarser.top, first);
            sums.add(texel, texels.coarser.bottom, first);
        }
        const real3 color = sums.light();
        store(color.x, light[0] + first);
        store(color.y, light[1] + first);
        store(color.z, light[2] + first);
    }
}

/// Writes the trilinear colour of chosen samples to `light`, and any to others of their registers.
/// Step by step for all of them: what a sample waits for is worked out for others meanwhile.
///
/// source  Williams 1983, "Pyramidal parametrics"
HWY_NOINLINE void sample_texture(const Texture& texture, const BlockSurface& surface,
    std::uint64_t samples, float (&light)[3][kBlockSamples])
{
    BlockTexels texels;
    BlockPlaces places;
    texels.blended = find_places(texture, surface, samples, places);
    find_texels<false>(texture, places, samples, texels.finer);
    find_texels<true>(texture, places, texels.blended, texels.coarser);
    weigh_texels(texture, texels, samples, light);
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
