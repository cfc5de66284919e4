// quantized_words-inl.h - arithmetic with words of four 16-bit numbers (quantized_points.h, which
// has a worked example), several words a register.
#if defined(FIRSTHIT_IRREGULAR_GRID_QUANTIZED_WORDS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_IRREGULAR_GRID_QUANTIZED_WORDS_INL_H_
#undef FIRSTHIT_IRREGULAR_GRID_QUANTIZED_WORDS_INL_H_
#else
#define FIRSTHIT_IRREGULAR_GRID_QUANTIZED_WORDS_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Words = hn::CappedTag<std::uint64_t, 8>;
using Word = hn::Vec<Words>;

#if HWY_TARGET == HWY_SCALAR
/// f of each of the four 16-bit numbers of two words.
template <class F>
HWY_INLINE Word each16(Word a, Word b, const F& f)
{
    std::uint64_t word = 0;
    for (int k = 0; k < 64; k += 16)
        word |=
            std::uint64_t(std::uint16_t(f(std::uint16_t(a.raw >> k), std::uint16_t(b.raw >> k))))
            << k;
    return hn::Set(Words(), word);
}
#else
/// f of all 16-bit numbers of two registers, which f takes as registers of 16-bit lanes.
template <class F>
HWY_INLINE Word each16(Word a, Word b, const F& f)
{
    const hn::Repartition<std::uint16_t, Words> d;
    return hn::BitCast(Words(), f(hn::BitCast(d, a), hn::BitCast(d, b)));
}
#endif

/// The minimum of each 16-bit number, unsigned.
HWY_INLINE Word least16(Word a, Word b)
{
#if HWY_TARGET == HWY_SCALAR
    return each16(a, b, [](auto p, auto q) { return std::min(p, q); });
#else
    return each16(a, b, [](auto p, auto q) { return hn::Min(p, q); });
#endif
}

/// The maximum of each 16-bit number, unsigned.
HWY_INLINE Word greatest16(Word a, Word b)
{
#if HWY_TARGET == HWY_SCALAR
    return each16(a, b, [](auto p, auto q) { return std::max(p, q); });
#else
    return each16(a, b, [](auto p, auto q) { return hn::Max(p, q); });
#endif
}

/// The difference of each 16-bit number, modulo 2^16.
HWY_INLINE Word difference16(Word a, Word b)
{
#if HWY_TARGET == HWY_SCALAR
    return each16(a, b, [](auto p, auto q) { return p - q; });
#else
    return each16(a, b, [](auto p, auto q) { return hn::Sub(p, q); });
#endif
}

/// The words in which a 16-bit number equals `what`. Only the numbers whose bits are set in `where`
/// count.
HWY_INLINE hn::Mask<Words> any16(Word v, std::uint16_t what, std::uint64_t where)
{
    const Words d;
#if HWY_TARGET == HWY_SCALAR
    const Word equal = each16(
        v, hn::Set(d, what * 0x0001000100010001u), [](auto p, auto q) { return p == q ? -1 : 0; });
#else
    const hn::Repartition<std::uint16_t, Words> n;
    const Word equal =
        hn::BitCast(d, hn::VecFromMask(n, hn::Eq(hn::BitCast(n, v), hn::Set(n, what))));
#endif
    return hn::Ne(hn::And(equal, hn::Set(d, where)), hn::Zero(d));
}

/// a.x * b.x + a.y * b.y in the upper 32 bits, x and y taken as signed. The lower half of b must be
/// 0; the lower half of the result is 0.
HWY_INLINE Word products16(Word a, Word b)
{
#if HWY_TARGET == HWY_SCALAR
    const auto part = [](Word v, int k) { return std::int64_t(std::int16_t(v.raw >> k)); };
    return hn::Set(
        Words(), std::uint64_t(part(a, 32) * part(b, 32) + part(a, 48) * part(b, 48)) << 32);
#else
    const hn::Repartition<std::int32_t, Words> d;
#if HWY_ARCH_X86 // adds the products of neighbouring lanes in one instruction
    const hn::Repartition<std::int16_t, Words> n;
    auto none = hn::Zero(d);
    return hn::BitCast(Words(),
        hn::ReorderWidenMulAccumulate(d, hn::BitCast(n, a), hn::BitCast(n, b), hn::Zero(d), none));
#else
    const auto low = [&](Word v) {
        return hn::ShiftRight<16>(hn::ShiftLeft<16>(hn::BitCast(d, v)));
    };
    const auto high = [&](Word v) { return hn::ShiftRight<16>(hn::BitCast(d, v)); };
    return hn::BitCast(Words(), hn::Add(hn::Mul(low(a), low(b)), hn::Mul(high(a), high(b))));
#endif
#endif
}

/// The words whose uppermost bit is set: that are negative as signed numbers of 64 bits.
HWY_INLINE hn::Mask<Words> below_zero(Word v)
{
    const hn::RebindToSigned<Words> i;
    return hn::RebindMask(Words(), hn::Lt(hn::BitCast(i, v), hn::Zero(i)));
}

/// Bit k is lane k of the mask.
HWY_INLINE std::uint32_t bits_of_words(hn::Mask<Words> mask)
{
    std::uint8_t byte[8] = {};
    hn::StoreMaskBits(Words(), mask, byte);
    return byte[0];
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
