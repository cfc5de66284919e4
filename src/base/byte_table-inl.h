// byte_table-inl.h - numbers for two bytes in each lane of a register.
#if defined(FIRSTHIT_BASE_BYTE_TABLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_BASE_BYTE_TABLE_INL_H_
#undef FIRSTHIT_BASE_BYTE_TABLE_INL_H_
#else
#define FIRSTHIT_BASE_BYTE_TABLE_INL_H_
#endif

#include "base/byte_table.h"
#include "base/simd_real-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

struct TwoReals {
    real first;  // of the byte in bits 0 to 7
    real second; // of that in bits 16 to 23
};

#if HWY_TARGET == HWY_AVX3
/// Of each 16-bit lane: half[lane], from 8 registers of 32. An instruction looks up in two of them,
/// by the lowest 6 bits of the lane; bits 6 and 7 choose among four.
FIRSTHIT_PURE __m512i look_up_half(
    const std::array<std::uint16_t, 256>& half, __m512i lane, __mmask32 bit6, __mmask32 bit7)
{
    const auto two = [&](int number) {
        const std::uint16_t* pair = half.data() + 64 * number;
        return _mm512_permutex2var_epi16(
            _mm512_load_si512(pair), lane, _mm512_load_si512(pair + 32));
    };
    return _mm512_mask_blend_epi16(bit7, _mm512_mask_blend_epi16(bit6, two(0), two(1)),
        _mm512_mask_blend_epi16(bit6, two(2), two(3)));
}
#endif

/// The other bits of the lanes are 0. AVX-512 has the table in registers' place: 20 instructions for
/// what two gathers of 16 elements take five times as long for.
FIRSTHIT_PURE TwoReals look_up_two_bytes(const ByteTable& table, integer bytes)
{
#if HWY_TARGET == HWY_AVX3
    const __m512i lane = bytes.lanes.raw;
    const __mmask32 bit6 = _mm512_test_epi16_mask(lane, _mm512_set1_epi16(64));
    const __mmask32 bit7 = _mm512_test_epi16_mask(lane, _mm512_set1_epi16(128));
    const integer high(hn::Vec<IntegerTag>{look_up_half(table.high, lane, bit6, bit7)});
    const integer low(hn::Vec<IntegerTag>{look_up_half(table.low, lane, bit6, bit7)});
    const auto join = [](auto upper, auto lower) {
        return intBitsToFloat(integer(hn::Or(upper, lower)));
    };
    const IntegerTag d;
    const hn::RebindToUnsigned<IntegerTag> bits;
    return {join(hn::ShiftLeft<16>(high.lanes), (low & 0xFFFF).lanes),
        join(hn::AndNot(integer(0xFFFF).lanes, high.lanes),
            hn::BitCast(d, hn::ShiftRight<16>(hn::BitCast(bits, low.lanes))))};
#else
    return {gather(table.value.data(), bytes & 0xFF),
        gather(table.value.data(), integer(hn::ShiftRight<16>(bytes.lanes)))};
#endif
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
