// sample_texture-inl.h - the texture's colour for a register of samples, trilinear.
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

#if HWY_TARGET == HWY_SCALAR

/// Sums of weighted texels, while levels are added.
class WeightedTexels {
  public:
    /// texel   the texture's
    void add(const Texel* texel, const Texels& at, const TexelWeights& weights)
    {
        const auto lane = [](integer i) { return hn::GetLane(i.lanes); };
        const Texel* const row[] = {texel + lane(at.top), texel + lane(at.bottom)};
        const std::int32_t left[] = {lane(weights.top_left), lane(weights.bottom_left)};
        const std::int32_t right[] = {lane(weights.top_right), lane(weights.bottom_right)};
        for (std::size_t c = 0; c < 3; ++c)
            for (int k = 0; k < 2; ++k) sum_[c] += left[k] * row[k][0][c] + right[k] * row[k][1][c];
    }

    real3 light() const
    {
        return real3(texel_light(sum_[0]), texel_light(sum_[1]), texel_light(sum_[2]));
    }

  private:
    std::int32_t sum_[3] = {};
};

#else

/// Sums of weighted texels, while levels are added.
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

    /// texel   the texture's
    HWY_INLINE void add(const Texel* texel, const Texels& at, const TexelWeights& weights)
    {
        add_row(texel, at.top, weights.top_left, weights.top_right);
        add_row(texel, at.bottom, weights.bottom_left, weights.bottom_right);
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

    HWY_INLINE void add_row(const Texel* texel, integer at, integer left, integer right)
    {
        alignas(64) std::int32_t index[kLanes];
        hn::Store(at.lanes, IntegerTag(), index);
        const Sum pair = hn::Add(left.lanes, hn::ShiftLeft<16>(right.lanes));
        sum_[0] = add_samples<0>(texel, index, pair, sum_[0]);
        sum_[1] = add_samples<1>(texel, index, pair, sum_[1]);
        sum_[2] = add_samples<2>(texel, index, pair, sum_[2]);
        sum_[3] = add_samples<3>(texel, index, pair, sum_[3]);
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

    Sum sum_[4];
};

#endif

/// Trilinear colour, for the chosen lanes; the others are undefined. Each lane has levels of its own;
/// where all chosen ones see enlarged texels, level 0 is enough.
///
/// source  Williams 1983, "Pyramidal parametrics"
HWY_INLINE real3 sample_texture(
    const Texture& texture, real u, real v, real length2, std::uint64_t chosen_bits)
{
    const real width(static_cast<float>(texture.width()));
    const real height(static_cast<float>(texture.height()));
    const real last(static_cast<float>(texture.levels() - 1));
    const real right = repeat(u);
    const real down = 1.0f - repeat(v);
    const real level = mip_level(length2, last);
    const real finer = floor(level);
    const real rest = level - finer;
    const integer coarse = whole_to_integer(rest * 32767.0f);

    WeightedTexels sums;
    const auto add = [&](real which, integer weight) {
        Texels at =
            bilinear_texels(right, down, level_size(width, which), level_size(height, which));
        const integer first = first_texel(texture, whole_to_integer(which));
        at.top = at.top + first;
        at.bottom = at.bottom + first;
        sums.add(texture.texels().data(), at, texel_weights(at, weight));
    };
    add(finer, whole_weight() - coarse);
    if (chosen_bits & bits_of_truth(rest > real(0.0f))) add(min(finer + 1.0f, last), coarse);
    return sums.light();
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
