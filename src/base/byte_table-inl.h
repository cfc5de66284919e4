// byte_table-inl.h - a table of 256 numbers, looked up by a register of bytes at once.
#if defined(FIRSTHIT_BASE_BYTE_TABLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_BASE_BYTE_TABLE_INL_H_
#undef FIRSTHIT_BASE_BYTE_TABLE_INL_H_
#else
#define FIRSTHIT_BASE_BYTE_TABLE_INL_H_
#endif

#include "base/simd_real-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// table[byte]; bytes are 0 to 255 in every lane, the table is aligned to 64 bytes.
FIRSTHIT_PURE real look_up_byte(const float* table, integer byte)
{
#if HWY_TARGET == HWY_AVX3
    // The table is 16 registers. One instruction looks up in two of them, by the lowest 5 bits, in
    // the time of one element of a gather: a third of the whole.
    const auto two = [&](int number) {
        const float* pair = table + 32 * number;
        return hn::Vec<RealTag>{_mm512_permutex2var_ps(
            _mm512_load_ps(pair), byte.lanes.raw, _mm512_load_ps(pair + 16))};
    };
    const auto bit = [&](int value) {
        return hn::RebindMask(RealTag(), hn::TestBit(byte.lanes, hn::Set(IntegerTag(), value)));
    };
    const auto bit5 = bit(32), bit6 = bit(64), bit7 = bit(128);
    const auto four = [&](int number) {
        return hn::IfThenElse(bit5, two(2 * number + 1), two(2 * number));
    };
    return real(hn::IfThenElse(
        bit7, hn::IfThenElse(bit6, four(3), four(2)), hn::IfThenElse(bit6, four(1), four(0))));
#else
    return gather(table, byte);
#endif
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
