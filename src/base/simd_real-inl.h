// simd_real-inl.h - the type `real` of src/glsl/ for kernels: one SIMD register.
#if defined(FIRSTHIT_BASE_SIMD_REAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_BASE_SIMD_REAL_INL_H_
#undef FIRSTHIT_BASE_SIMD_REAL_INL_H_
#else
#define FIRSTHIT_BASE_SIMD_REAL_INL_H_
#endif

#include "base/pure.h"

#include <hwy/highway.h>

#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using RealTag = hn::ScalableTag<float>;
using IntegerTag = hn::RebindToSigned<RealTag>;

/// How many samples a real holds: 1, 4, 8 or 16.
inline constexpr int kLanes = static_cast<int>(hn::MaxLanes(RealTag()));
static_assert(kLanes == 1 || kLanes == 4 || kLanes == 8 || kLanes == 16);

/// One boolean for each lane.
struct truth {
    hn::Mask<RealTag> lanes;
};

/// One int32 for each lane.
struct integer {
    hn::Vec<IntegerTag> lanes;
    integer() = default;
    HWY_INLINE integer(int same) : lanes(hn::Set(IntegerTag(), same)) {}
    HWY_INLINE explicit integer(hn::Vec<IntegerTag> vector) : lanes(vector) {}
};

/// One float for each lane.
struct real {
    hn::Vec<RealTag> lanes;
    real() = default;
    HWY_INLINE real(float same) : lanes(hn::Set(RealTag(), same)) {}
    HWY_INLINE explicit real(hn::Vec<RealTag> vector) : lanes(vector) {}
    HWY_INLINE explicit real(integer i) : lanes(hn::ConvertTo(RealTag(), i.lanes)) {}
};

FIRSTHIT_PURE real operator+(real a, real b)
{
    return real(hn::Add(a.lanes, b.lanes));
}
FIRSTHIT_PURE real operator-(real a, real b)
{
    return real(hn::Sub(a.lanes, b.lanes));
}
FIRSTHIT_PURE real operator*(real a, real b)
{
    return real(hn::Mul(a.lanes, b.lanes));
}
FIRSTHIT_PURE real operator/(real a, real b)
{
    return real(hn::Div(a.lanes, b.lanes));
}
FIRSTHIT_PURE truth operator>(real a, real b)
{
    return {hn::Gt(a.lanes, b.lanes)};
}
FIRSTHIT_PURE truth operator>=(real a, real b)
{
    return {hn::Ge(a.lanes, b.lanes)};
}
FIRSTHIT_PURE truth operator<(real a, real b)
{
    return {hn::Lt(a.lanes, b.lanes)};
}

FIRSTHIT_PURE real sqrt(real a)
{
    return real(hn::Sqrt(a.lanes));
}
FIRSTHIT_PURE real floor(real a)
{
    return real(hn::Floor(a.lanes));
}

/// b where `choose_b`, else a, as in GLSL.
FIRSTHIT_PURE real mix(real a, real b, truth choose_b)
{
    return real(hn::IfThenElse(choose_b.lanes, b.lanes, a.lanes));
}

/// min and max give b where either argument is NaN (x86's rule, emulated on other targets), so pass
/// the constant as b.
FIRSTHIT_PURE real min(real a, real b)
{
#if HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
    return real(hn::Min(a.lanes, b.lanes));
#else
    return mix(b, a, a < b);
#endif
}
FIRSTHIT_PURE real max(real a, real b)
{
#if HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
    return real(hn::Max(a.lanes, b.lanes));
#else
    return mix(b, a, a > b);
#endif
}

FIRSTHIT_PURE integer operator+(integer a, integer b)
{
    return integer(hn::Add(a.lanes, b.lanes));
}
FIRSTHIT_PURE integer operator-(integer a, integer b)
{
    return integer(hn::Sub(a.lanes, b.lanes));
}
FIRSTHIT_PURE integer operator*(integer a, integer b)
{
    return integer(hn::Mul(a.lanes, b.lanes));
}
FIRSTHIT_PURE integer operator&(integer a, integer b)
{
    return integer(hn::And(a.lanes, b.lanes));
}
FIRSTHIT_PURE integer shift_left_23(integer a)
{
    return integer(hn::ShiftLeft<23>(a.lanes));
}
FIRSTHIT_PURE integer shift_right_23(integer a)
{
    return integer(hn::ShiftRight<23>(a.lanes));
}
FIRSTHIT_PURE integer shift_right_15(integer a)
{
    return integer(hn::ShiftRight<15>(a.lanes));
}
FIRSTHIT_PURE integer floatBitsToInt(real a)
{
    return integer(hn::BitCast(IntegerTag(), a.lanes));
}
FIRSTHIT_PURE real intBitsToFloat(integer a)
{
    return real(hn::BitCast(RealTag(), a.lanes));
}

/// Load from and store to an array that is aligned to 64 bytes, at a multiple of kLanes.
FIRSTHIT_PURE real load(const float* p)
{
    return real(hn::Load(RealTag(), p));
}
FIRSTHIT_PURE void store(real a, float* p)
{
    hn::Store(a.lanes, RealTag(), p);
}

/// Writes the chosen lanes. The other lanes are read and written back, which is as fast as a masked
/// store with AVX-512 (measured) and faster with AVX2 on AMD, where masked stores are microcode.
FIRSTHIT_PURE void store_where(truth chosen, real a, float* p)
{
    store(mix(load(p), a, chosen), p);
}

/// Converts the kLanes lowest bits to lanes, bit 0 to lane 0.
FIRSTHIT_PURE truth truth_of_bits(std::uint64_t bits)
{
    std::uint8_t bytes[8]; // Highway reads 8, lowest first
    std::memcpy(bytes, &bits, sizeof bits);
    return {hn::LoadMaskBits(RealTag(), bytes)};
}

/// Converts the lanes to the kLanes lowest bits.
FIRSTHIT_PURE std::uint64_t bits_of_truth(truth a)
{
    std::uint8_t bytes[8] = {}; // Highway writes up to 8
    hn::StoreMaskBits(RealTag(), a.lanes, bytes);
    return (bytes[0] | std::uint64_t(bytes[1]) << 8) & ((std::uint64_t(1) << kLanes) - 1);
}

/// Extracts the bits of samples [first, first + kLanes) from the bits of a block's samples.
FIRSTHIT_PURE std::uint64_t lane_bits(std::uint64_t samples, int first)
{
    return (samples >> first) & ((std::uint64_t(1) << kLanes) - 1);
}

/// Table look-up. The index of every lane must be inside the table.
FIRSTHIT_PURE real gather(const float* table, integer index)
{
    return real(hn::GatherIndex(RealTag(), table, index.lanes));
}
FIRSTHIT_PURE integer gather(const std::uint32_t* table, integer index)
{
    return integer(
        hn::GatherIndex(IntegerTag(), reinterpret_cast<const std::int32_t*>(table), index.lanes));
}

#include "base/real_vectors.inl"

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
