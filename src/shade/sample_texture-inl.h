// sample_texture-inl.h - samples a texture trilinearly for the samples of a block.
#if defined(FIRSTHIT_SHADE_SAMPLE_TEXTURE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SHADE_SAMPLE_TEXTURE_INL_H_
#undef FIRSTHIT_SHADE_SAMPLE_TEXTURE_INL_H_
#else
#define FIRSTHIT_SHADE_SAMPLE_TEXTURE_INL_H_
#endif

#include "shade/block_attributes-inl.h"

#include <firsthit/texture.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// Selects a in the lanes of `choose_a`, b in the others.
FIRSTHIT_PURE real3 select3(truth choose_a, real3 a, real3 b)
{
    return real3(mix(b.x, a.x, choose_a), mix(b.y, a.y, choose_a), mix(b.z, a.z, choose_a));
}

/// The index of the first texel of each lane's mip level.
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

/// The texels that are read for the samples of a block, and their weights. Undefined for registers
/// without chosen samples.
struct BlockTexels {
    /// Pairs of horizontally neighbouring texels.
    struct alignas(64) Pairs {
        std::int32_t left[kBlockSamples]; // index of the left texel; the right one is next
        std::int32_t
            weights[kBlockSamples]; // weight of the right texel * 2^16 + that of the left one
    };
    struct Level {
        Pairs top, bottom;
    };
    Level finer, coarser;
    std::uint64_t blended; // bits of the samples that also read the coarser level
};

/// Texture coordinates and mip levels of the samples of a block.
struct alignas(64) BlockTexCoords {
    float right[kBlockSamples];                 // from the left edge, 0 to 1
    float down[kBlockSamples];                  // from the top edge, 0 to 1
    float finer[kBlockSamples];                 // the finer of the two levels that are blended
    std::int32_t coarser_weight[kBlockSamples]; // weight of the coarser level, 0 to whole_weight()
};

/// A texture, and how the samples of a block look it up.
struct MapLookup {
    const Texture& texture;
    const TextureRef& map; // of which the transform is used
    const float (&uv)[2][kBlockSamples];
    const float (&footprint2)[kBlockSamples]; // of the transformed coordinates
};

/// The same as find_tex_coords, for every sampler and transform.
HWY_INLINE std::uint64_t find_map_coords(
    const MapLookup& lookup, std::uint64_t samples, BlockTexCoords& coords)
{
    const Sampler& sampler = lookup.texture.sampler();
    const real last(sampler.nearest ? 0.0f : static_cast<float>(lookup.texture.levels() - 1));
    const glm::mat3x2& m = lookup.map.transform;
    std::uint64_t blended = 0;
    for (int first = 0; first < kBlockSamples; first += kLanes) {
        if (lane_bits(samples, first) == 0) continue;
        const real u = load(lookup.uv[0] + first), v = load(lookup.uv[1] + first);
        const real level = mip_level(load(lookup.footprint2 + first), last);
        const real finer = floor(level);
        const real rest = level - finer;
        store(finer, coords.finer + first);
        store(
            wrapped((m[0].x * u + m[1].x * v) + m[2].x, int(sampler.wrap_u)), coords.right + first);
        store(1.0f - wrapped((m[0].y * u + m[1].y * v) + m[2].y, int(sampler.wrap_v)),
            coords.down + first);
        hn::Store(
            whole_to_integer(rest * 32767.0f).lanes, IntegerTag(), coords.coarser_weight + first);
        blended |= bits_of_truth(rest > real(0.0f)) << first;
    }
    return blended & samples;
}

/// Computes texture coordinates and mip levels. Each sample blends two neighbouring levels. Returns
/// the bits of the samples for which the coarser level has a weight; where the texture is magnified
/// there are none.
HWY_INLINE std::uint64_t find_tex_coords(const Texture& texture, const BlockAttributes& attributes,
    std::uint64_t samples, BlockTexCoords& coords)
{
    const real last(static_cast<float>(texture.levels() - 1));
    const Sampler& sampler = texture.sampler();
    if (sampler.nearest || sampler.wrap_u != Wrap::repeat || sampler.wrap_v != Wrap::repeat)
        return find_map_coords(
            {texture, {}, attributes.uv, attributes.footprint2}, samples, coords);
    std::uint64_t blended = 0;
    for (int first = 0; first < kBlockSamples; first += kLanes) {
        if (lane_bits(samples, first) == 0) continue;
        const real level = mip_level(load(attributes.footprint2 + first), last);
        const real finer = floor(level);
        const real rest = level - finer;
        store(finer, coords.finer + first);
        store(repeat(load(attributes.uv[0] + first)), coords.right + first);
        store(1.0f - repeat(load(attributes.uv[1] + first)), coords.down + first);
        hn::Store(
            whole_to_integer(rest * 32767.0f).lanes, IntegerTag(), coords.coarser_weight + first);
        blended |= bits_of_truth(rest > real(0.0f)) << first;
    }
    return blended & samples;
}

/// Finds the texels and weights of the finer or of the coarser level.
template <bool coarser>
HWY_INLINE void find_texels(const Texture& texture, const BlockTexCoords& coords,
    std::uint64_t samples, BlockTexels::Level& texels)
{
    const real width(static_cast<float>(texture.width()));
    const real height(static_cast<float>(texture.height()));
    const real last(static_cast<float>(texture.levels() - 1));
    const IntegerTag d;
    for (int first = 0; first < kBlockSamples; first += kLanes) {
        if (lane_bits(samples, first) == 0) continue;
        const real right = load(coords.right + first);
        const real down = load(coords.down + first);
        real level = load(coords.finer + first);
        integer weight(hn::Load(d, coords.coarser_weight + first));
        if (coarser)
            level = min(level + 1.0f, last);
        else
            weight = whole_weight() - weight;

        const Texels at =
            texture.sampler().nearest
                ? nearest_texels(right, down, width, height)
                : bilinear_texels(right, down, level_size(width, level), level_size(height, level));
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

/// Accumulates sums of weighted texels for a register of samples.
class WeightedTexels {
  public:
    /// texel  all texels of the texture
    void add(const Texel* texel, const BlockTexels::Pairs& pairs, int first)
    {
        for (int lane = 0; lane < kLanes; ++lane) {
            const Texel* const left = texel + pairs.left[first + lane];
            const std::int32_t weights = pairs.weights[first + lane];
            for (std::size_t c = 0; c < 4; ++c)
                sum_[c][lane] += (weights & 0xFFFF) * left[0][c] + (weights >> 16) * left[1][c];
        }
    }

    real3 light() const { return real3(channel(0), channel(1), channel(2)); }
    real alpha() const { return channel(3); }

  private:
    real channel(int c) const { return texel_light(integer(hn::Load(IntegerTag(), sum_[c]))); }

    alignas(64) std::int32_t sum_[4][kLanes] = {};
};

#else

/// Accumulates sums of weighted texels for a register of samples.
///
/// Two neighbouring texels are 16 bytes, a single load. A register holds the pairs of every fourth
/// sample: with 16 lanes, those of samples 0, 4, 8 and 12, and so on. Once the channels of both
/// texels are side by side, one instruction multiplies both with their weights and adds the
/// products. The sums are transposed at the end.
class WeightedTexels {
  public:
    HWY_INLINE WeightedTexels()
    {
        for (Sum& sum : sum_) sum = hn::Zero(IntegerTag());
    }

    /// texel  all texels of the texture
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
    HWY_INLINE real alpha() const
    {
        const IntegerTag d;
        return texel_light(integer(hn::InterleaveUpper(d, hn::InterleaveUpper(d, sum_[0], sum_[2]),
            hn::InterleaveUpper(d, sum_[1], sum_[3]))));
    }

  private:
    using Sum = hn::Vec<IntegerTag>;

    /// Loads two texels at every fourth index.
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

    /// Adds the pairs of samples k, k + 4, ...
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
        Sum none = hn::Zero(IntegerTag()); // second sum of the instruction; stays 0 on x86
        return hn::ReorderWidenMulAccumulate(
            IntegerTag(), pairs, hn::BitCast(d, hn::Broadcast<k>(weights)), sum, none);
    }

    Sum sum_[4];
};

#endif

/// Writes the linear colours of the chosen samples. Other samples of the same registers become
/// garbage.
///
/// alpha  whether to write alpha, too
template <bool alpha, int channels>
HWY_NOINLINE void weigh_texels(const Texture& texture, const BlockTexels& texels,
    std::uint64_t samples, float (&light)[channels][kBlockSamples])
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
        if constexpr (alpha) store(sums.alpha(), light[3] + first);
    }
}

/// Writes the trilinear colours of the chosen samples to `light`, linear. Other samples of the same
/// registers become garbage. Each step is done for all samples before the next one begins, so that
/// the processor computes some samples while it waits for the memory of others.
///
/// source  Williams 1983, "Pyramidal parametrics"
HWY_NOINLINE void sample_texture(const Texture& texture, const BlockAttributes& attributes,
    std::uint64_t samples, float (&light)[3][kBlockSamples])
{
    BlockTexels texels;
    BlockTexCoords coords;
    texels.blended = find_tex_coords(texture, attributes, samples, coords);
    find_texels<false>(texture, coords, samples, texels.finer);
    find_texels<true>(texture, coords, texels.blended, texels.coarser);
    weigh_texels<false>(texture, texels, samples, light);
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
