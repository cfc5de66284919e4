// sample_environment-inl.h - looks up the environment for two registers of samples.
#if defined(FIRSTHIT_SHADE_SAMPLE_ENVIRONMENT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SHADE_SAMPLE_ENVIRONMENT_INL_H_
#undef FIRSTHIT_SHADE_SAMPLE_ENVIRONMENT_INL_H_
#else
#define FIRSTHIT_SHADE_SAMPLE_ENVIRONMENT_INL_H_
#endif

#include "material/models-inl.h"
#include "shade/shade_environment.h"

#include <array>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
/// The value of a table of 16 in each lane.
FIRSTHIT_PURE real small_table(const std::array<float, 16>& table, integer index)
{
#if HWY_TARGET == HWY_AVX3
    static_assert(kLanes == 16);
    const RealTag d;
    return real(
        hn::TableLookupLanes(hn::Load(d, table.data()), hn::IndicesFromVec(d, index.lanes)));
#else
    return gather(table.data(), index);
#endif
}

/// FourWeights of a register of samples.
struct LaneWeights {
    real top_left, top_right, bottom_left, bottom_right;
};

#if HWY_TARGET == HWY_SCALAR || !HWY_ARCH_X86

/// The weighted sums of four texels for each sample of a register.
HWY_INLINE real3 weighted_light(
    const float* texel, integer top, integer bottom, const LaneWeights& weights)
{
    const auto channel = [&](integer k, int c) {
        return gather(texel + c, integer(hn::ShiftLeft<2>(k.lanes)));
    };
    const auto sum = [&](int c) {
        return ((channel(top, c) * weights.top_left +
                    channel(top + integer(1), c) * weights.top_right) +
                   channel(bottom, c) * weights.bottom_left) +
               channel(bottom + integer(1), c) * weights.bottom_right;
    };
    return real3(sum(0), sum(1), sum(2));
}

#else

/// Loads texels of 16 bytes at every fourth index.
HWY_INLINE real load_quads(const float* texel, const std::int32_t* index)
{
    const auto quad = [&](int lane) {
        return hn::LoadU(hn::Full128<float>(), texel + 4 * std::ptrdiff_t(index[lane]));
    };
#if HWY_TARGET == HWY_AVX3
    const hn::Full256<float> half;
    return real(hn::Combine(hn::Full512<float>(), hn::Combine(half, quad(12), quad(8)),
        hn::Combine(half, quad(4), quad(0))));
#elif HWY_TARGET == HWY_AVX2
    return real(hn::Combine(hn::Full256<float>(), quad(4), quad(0)));
#else
    return real(quad(0));
#endif
}

/// The weighted sums of samples k, k + 4, ...: all four channels of each.
template <int k>
HWY_INLINE hn::Vec<RealTag> weighted_quads(const float* texel, const std::int32_t* top,
    const std::int32_t* bottom, const LaneWeights& weights)
{
    const auto weighted = [&](const float* from, const std::int32_t* index, const real& weight) {
        return load_quads(from, index + k) * real(hn::Broadcast<k>(weight.lanes));
    };
    return (
        ((weighted(texel, top, weights.top_left) + weighted(texel + 4, top, weights.top_right)) +
            weighted(texel, bottom, weights.bottom_left)) +
        weighted(texel + 4, bottom, weights.bottom_right))
        .lanes;
}

/// The weighted sums of four texels for each sample of a register. Loading a texel whole is quicker than
/// gathering its channels; the sums are transposed at the end, as in sample_texture-inl.h.
HWY_INLINE real3 weighted_light(
    const float* texel, integer top, integer bottom, const LaneWeights& weights)
{
    const IntegerTag di;
    alignas(64) std::int32_t index[2][kLanes];
    hn::Store(top.lanes, di, index[0]);
    hn::Store(bottom.lanes, di, index[1]);
    const auto sum0 = weighted_quads<0>(texel, index[0], index[1], weights);
    const auto sum1 = weighted_quads<1>(texel, index[0], index[1], weights);
    const auto sum2 = weighted_quads<2>(texel, index[0], index[1], weights);
    const auto sum3 = weighted_quads<3>(texel, index[0], index[1], weights);
    const RealTag d;
    const auto red_green_02 = hn::InterleaveLower(d, sum0, sum2);
    const auto red_green_13 = hn::InterleaveLower(d, sum1, sum3);
    const auto blue_02 = hn::InterleaveUpper(d, sum0, sum2);
    const auto blue_13 = hn::InterleaveUpper(d, sum1, sum3);
    return real3(real(hn::InterleaveLower(d, red_green_02, red_green_13)),
        real(hn::InterleaveUpper(d, red_green_02, red_green_13)),
        real(hn::InterleaveLower(d, blue_02, blue_13)));
}

#endif

namespace wide {

/// What environment.glsl looks up in.
struct EnvironmentTables {
    const ShadeEnvironment* shade;
};

FIRSTHIT_PURE vec3 diffuse_term(EnvironmentTables tables, int k)
{
    return tables.shade->diffuse[k];
}

FIRSTHIT_PURE real level_side(EnvironmentTables tables, real level)
{
    const integer k = whole_to_integer(level);
    return real(small_table(tables.shade->side, k.low), small_table(tables.shade->side, k.high));
}

FIRSTHIT_PURE real level_first(EnvironmentTables tables, real level)
{
    const integer k = whole_to_integer(level);
    return real(small_table(tables.shade->first, k.low), small_table(tables.shade->first, k.high));
}

FIRSTHIT_PURE real table_first(EnvironmentTables tables)
{
    return real(tables.shade->table);
}

HWY_INLINE real3 weighted_light(
    EnvironmentTables tables, integer top, integer bottom, FourWeights weights)
{
    const HWY_NAMESPACE::real3 low =
        HWY_NAMESPACE::weighted_light(tables.shade->texel, top.low, bottom.low,
            {weights.top_left.low, weights.top_right.low, weights.bottom_left.low,
                weights.bottom_right.low});
    const HWY_NAMESPACE::real3 high =
        HWY_NAMESPACE::weighted_light(tables.shade->texel, top.high, bottom.high,
            {weights.top_left.high, weights.top_right.high, weights.bottom_left.high,
                weights.bottom_right.high});
    return real3(real(low.x, high.x), real(low.y, high.y), real(low.z, high.z));
}

FIRSTHIT_PURE real environment_strength(EnvironmentTables tables)
{
    return real(tables.shade->strength);
}

FIRSTHIT_PURE real3 turned_back(real3 d, float cosine, float sine);

FIRSTHIT_PURE real3 environment_space(EnvironmentTables tables, real3 d)
{
    return turned_back(d, tables.shade->cosine, tables.shade->sine);
}

#include "glsl/environment.glsl"

} // namespace wide
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
