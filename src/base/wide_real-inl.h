// wide_real-inl.h - the type `real` of src/glsl/ for long dependency chains: two SIMD registers.
//
// Shading a sample is a chain of some hundred operations that depend on each other. Interleaving
// two independent registers, operation by operation, hides their latency; out-of-order execution
// alone does not reach far enough ahead. Each lane has the same bits as in simd_real-inl.h.
#if defined(FIRSTHIT_BASE_WIDE_REAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_BASE_WIDE_REAL_INL_H_
#undef FIRSTHIT_BASE_WIDE_REAL_INL_H_
#else
#define FIRSTHIT_BASE_WIDE_REAL_INL_H_
#endif

#include "base/simd_real-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace wide {

using OneReal = HWY_NAMESPACE::real;
using OneTruth = HWY_NAMESPACE::truth;
using OneInteger = HWY_NAMESPACE::integer;

/// How many samples a real holds: 2, 8, 16 or 32.
inline constexpr int kLanes = 2 * HWY_NAMESPACE::kLanes;

struct truth {
    OneTruth low, high;
};

struct integer {
    OneInteger low, high;
    integer() = default;
    HWY_INLINE integer(int same) : low(same), high(same) {}
    HWY_INLINE integer(OneInteger low_, OneInteger high_) : low(low_), high(high_) {}
};

struct real {
    OneReal low, high; // samples [0, kLanes / 2), and the rest
    real() = default;
    HWY_INLINE real(float same) : low(same), high(same) {}
    HWY_INLINE explicit real(OneReal both) : low(both), high(both) {}
    HWY_INLINE real(OneReal low_, OneReal high_) : low(low_), high(high_) {}
    HWY_INLINE explicit real(integer i) : low(i.low), high(i.high) {}
};

FIRSTHIT_PURE real operator+(real a, real b)
{
    return real(a.low + b.low, a.high + b.high);
}
FIRSTHIT_PURE real operator-(real a, real b)
{
    return real(a.low - b.low, a.high - b.high);
}
FIRSTHIT_PURE real operator*(real a, real b)
{
    return real(a.low * b.low, a.high * b.high);
}
FIRSTHIT_PURE real operator/(real a, real b)
{
    return real(a.low / b.low, a.high / b.high);
}
FIRSTHIT_PURE truth operator>(real a, real b)
{
    return {a.low > b.low, a.high > b.high};
}
FIRSTHIT_PURE truth operator>=(real a, real b)
{
    return {a.low >= b.low, a.high >= b.high};
}
FIRSTHIT_PURE truth operator<(real a, real b)
{
    return {a.low < b.low, a.high < b.high};
}

FIRSTHIT_PURE real sqrt(real a)
{
    return real(HWY_NAMESPACE::sqrt(a.low), HWY_NAMESPACE::sqrt(a.high));
}
FIRSTHIT_PURE real floor(real a)
{
    return real(HWY_NAMESPACE::floor(a.low), HWY_NAMESPACE::floor(a.high));
}
FIRSTHIT_PURE real mix(real a, real b, truth choose_b)
{
    return real(HWY_NAMESPACE::mix(a.low, b.low, choose_b.low),
        HWY_NAMESPACE::mix(a.high, b.high, choose_b.high));
}
FIRSTHIT_PURE real min(real a, real b)
{
    return real(HWY_NAMESPACE::min(a.low, b.low), HWY_NAMESPACE::min(a.high, b.high));
}
FIRSTHIT_PURE real max(real a, real b)
{
    return real(HWY_NAMESPACE::max(a.low, b.low), HWY_NAMESPACE::max(a.high, b.high));
}

FIRSTHIT_PURE integer operator+(integer a, integer b)
{
    return integer(a.low + b.low, a.high + b.high);
}
FIRSTHIT_PURE integer operator-(integer a, integer b)
{
    return integer(a.low - b.low, a.high - b.high);
}
FIRSTHIT_PURE integer shift_left_23(integer a)
{
    return integer(HWY_NAMESPACE::shift_left_23(a.low), HWY_NAMESPACE::shift_left_23(a.high));
}
FIRSTHIT_PURE integer shift_right_23(integer a)
{
    return integer(HWY_NAMESPACE::shift_right_23(a.low), HWY_NAMESPACE::shift_right_23(a.high));
}
FIRSTHIT_PURE integer floatBitsToInt(real a)
{
    return integer(HWY_NAMESPACE::floatBitsToInt(a.low), HWY_NAMESPACE::floatBitsToInt(a.high));
}
FIRSTHIT_PURE real intBitsToFloat(integer a)
{
    return real(HWY_NAMESPACE::intBitsToFloat(a.low), HWY_NAMESPACE::intBitsToFloat(a.high));
}

/// Load from and store to an array that is aligned to 64 bytes, at a multiple of kLanes.
FIRSTHIT_PURE real load(const float* p)
{
    return real(HWY_NAMESPACE::load(p), HWY_NAMESPACE::load(p + kLanes / 2));
}
FIRSTHIT_PURE void store_where(truth chosen, real a, float* p)
{
    HWY_NAMESPACE::store_where(chosen.low, a.low, p);
    HWY_NAMESPACE::store_where(chosen.high, a.high, p + kLanes / 2);
}
FIRSTHIT_PURE void store(real a, float* p)
{
    HWY_NAMESPACE::store(a.low, p);
    HWY_NAMESPACE::store(a.high, p + kLanes / 2);
}

/// Convert the kLanes lowest bits to lanes, bit 0 to lane 0, and back.
FIRSTHIT_PURE truth truth_of_bits(std::uint64_t bits)
{
    return {HWY_NAMESPACE::truth_of_bits(bits), HWY_NAMESPACE::truth_of_bits(bits >> (kLanes / 2))};
}
FIRSTHIT_PURE std::uint64_t bits_of_truth(truth a)
{
    return HWY_NAMESPACE::bits_of_truth(a.low) | HWY_NAMESPACE::bits_of_truth(a.high)
                                                     << (kLanes / 2);
}

/// Extracts the bits of samples [first, first + kLanes) from the bits of a block's samples.
FIRSTHIT_PURE std::uint64_t lane_bits(std::uint64_t samples, int first)
{
    return (samples >> first) & ((std::uint64_t(1) << kLanes) - 1);
}

#include "base/real_vectors.inl"

/// Broadcasts one register to both.
FIRSTHIT_PURE real3 both(const HWY_NAMESPACE::real3& v)
{
    return real3(real(v.x), real(v.y), real(v.z));
}

} // namespace wide
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
