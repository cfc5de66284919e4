// sample_texture-inl.h - the texture's colour for a register of samples, trilinear.
#if defined(FIRSTHIT_SHADE_SAMPLE_TEXTURE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SHADE_SAMPLE_TEXTURE_INL_H_
#undef FIRSTHIT_SHADE_SAMPLE_TEXTURE_INL_H_
#else
#define FIRSTHIT_SHADE_SAMPLE_TEXTURE_INL_H_
#endif

#include "base/byte_table-inl.h"
#include "shade/block_surface-inl.h"

#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// Linear colours of RGBA texels, blended: `right` of the right ones.
FIRSTHIT_PURE real3 blend_texels(
    integer at_left, integer at_right, real right, const ByteTable& linear)
{
    const auto green_of = [](integer texel) {
        return integer(hn::ShiftRight<8>(texel.lanes)) & 0xFF;
    };
    const TwoReals red_blue_left = look_up_two_bytes(linear, at_left & 0xFF00FF);
    const TwoReals red_blue_right = look_up_two_bytes(linear, at_right & 0xFF00FF);
    const TwoReals green = look_up_two_bytes(linear,
        integer(hn::Or(green_of(at_left).lanes, hn::ShiftLeft<16>(green_of(at_right).lanes))));
    return real3(blend(red_blue_left.first, red_blue_right.first, right),
        blend(green.first, green.second, right),
        blend(red_blue_left.second, red_blue_right.second, right));
}

/// Whether in all lanes the right texels lie beside the left ones, and so can be fetched in pairs.
FIRSTHIT_PURE bool in_pairs(const Texels& at)
{
#if HWY_TARGET == HWY_AVX3
    // Not where the texture begins anew.
    return hn::AllTrue(IntegerTag(), hn::Eq(at.top_right.lanes, (at.top_left + integer(1)).lanes));
#else
    (void)at;
    return false;
#endif
}

/// texel[left] and texel[right].
FIRSTHIT_PURE void fetch_texels(const std::uint32_t* texel, integer left, integer right, bool pairs,
    integer& at_left, integer& at_right)
{
    (void)pairs;
#if HWY_TARGET == HWY_AVX3
    // An element of a gather takes the same time with 32 bits and with 64.
    if (pairs) {
        const hn::Half<IntegerTag> half;
        const hn::ScalableTag<std::int64_t> wide;
        const auto fetch = [&](auto index) {
            return hn::BitCast(
                IntegerTag(), hn::GatherOffset(wide, reinterpret_cast<const std::int64_t*>(texel),
                                  hn::ShiftLeft<2>(hn::PromoteTo(wide, index))));
        };
        const auto low = fetch(hn::LowerHalf(half, left.lanes));
        const auto high = fetch(hn::UpperHalf(half, left.lanes));
        at_left = integer(hn::ConcatEven(IntegerTag(), high, low));
        at_right = integer(hn::ConcatOdd(IntegerTag(), high, low));
        return;
    }
#endif
    at_left = gather(texel, left);
    at_right = gather(texel, right);
}

/// Whether every index that bilinear_texels makes is inside the level.
inline bool can_sample(const Texture::Level& level)
{
    constexpr int kMaxSide = 1 << 22;
    return level.width > 0 && level.height > 0 && level.width <= kMaxSide &&
           level.height <= kMaxSide &&
           std::int64_t(level.width) * level.height <= std::numeric_limits<std::int32_t>::max() &&
           level.texel.size() >= std::size_t(level.width) * std::size_t(level.height);
}

/// Bilinear colour in one level; white where the level cannot be sampled.
HWY_INLINE real3 sample_level(const Texture::Level& level, real u, real v, const ByteTable& linear)
{
    if (!can_sample(level)) return real3(1.0f, 1.0f, 1.0f);
    const Texels at =
        bilinear_texels(u, v, static_cast<float>(level.width), static_cast<float>(level.height));
    const std::uint32_t* texel = level.texel.data();
    const bool pairs = in_pairs(at);
    const auto row = [&](integer left, integer right) {
        integer at_left, at_right;
        fetch_texels(texel, left, right, pairs, at_left, at_right);
        return blend_texels(at_left, at_right, at.right, linear);
    };
    const real3 top = row(at.top_left, at.top_right);
    const real3 bottom = row(at.bottom_left, at.bottom_right);
    return blend3(top, bottom, at.bottom);
}

/// a where `choose_a` in its lanes, else b.
FIRSTHIT_PURE real3 select3(truth choose_a, real3 a, real3 b)
{
    return real3(mix(b.x, a.x, choose_a), mix(b.y, a.y, choose_a), mix(b.z, a.z, choose_a));
}

/// Trilinear colour, for the chosen lanes; the others are undefined.
///
/// Goes through the levels that the chosen lanes need, seldom more than three; where all of them
/// see enlarged texels, through level 0 alone.
///
/// source  Williams 1983, "Pyramidal parametrics"
HWY_INLINE real3 sample_texture(const Texture& texture, real u, real v, real length2,
    std::uint64_t chosen_bits, const ByteTable& linear)
{
    const int last = static_cast<int>(texture.levels.size()) - 1;
    const real level = mip_level(length2, static_cast<float>(last));
    const real finer = floor(level);
    const real amount = level - finer; // of the coarser level

    real3 fine_color(0.0f, 0.0f, 0.0f);
    real3 coarse_color(0.0f, 0.0f, 0.0f);
    std::uint64_t fine_open = chosen_bits; // lanes whose finer level is still to come
    std::uint64_t coarse_open = chosen_bits & bits_of_truth(amount > real(0.0f));
    for (int i = 0; i <= last && (fine_open | coarse_open) != 0; ++i) {
        const truth is_fine{hn::Eq(finer.lanes, real(static_cast<float>(i)).lanes)};
        const truth is_coarse{hn::Eq(finer.lanes, real(static_cast<float>(i - 1)).lanes)};
        const std::uint64_t fine_here = bits_of_truth(is_fine) & fine_open;
        const std::uint64_t coarse_here = bits_of_truth(is_coarse) & coarse_open;
        if ((fine_here | coarse_here) == 0) continue;
        const real3 color = sample_level(texture.levels[std::size_t(i)], u, v, linear);
        fine_color = select3(is_fine, color, fine_color);
        coarse_color = select3(is_coarse, color, coarse_color);
        fine_open &= ~fine_here;
        coarse_open &= ~coarse_here;
    }
    return blend3(fine_color, coarse_color, amount);
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
