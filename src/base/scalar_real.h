// scalar_real.h - the type `real` of src/glsl/ for scalar C++ code: a float.
//
// Each operation gives the same bits as one lane of the same operation in simd_real-inl.h.
#pragma once

#include "base/pure.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace firsthit::scalar {

using real = float;
using integer = std::int32_t;
using truth = bool;

FIRSTHIT_PURE real min(real a, real b)
{
    return a < b ? a : b;
}
FIRSTHIT_PURE real max(real a, real b)
{
    return a > b ? a : b;
}
FIRSTHIT_PURE real sqrt(real a)
{
    return std::sqrt(a);
}
FIRSTHIT_PURE real floor(real a)
{
    return std::floor(a);
}
FIRSTHIT_PURE real mix(real a, real b, truth choose_b)
{
    return choose_b ? b : a;
}

/// Shifts as SIMD lanes do: left shifts wrap around, right shifts copy the sign.
FIRSTHIT_PURE integer shift_left_23(integer a)
{
    return static_cast<integer>(static_cast<std::uint32_t>(a) << 23);
}
FIRSTHIT_PURE integer shift_right_23(integer a)
{
    return a >> 23;
}
FIRSTHIT_PURE integer shift_right_15(integer a)
{
    return a >> 15;
}
FIRSTHIT_PURE integer floatBitsToInt(real a)
{
    return std::bit_cast<integer>(a);
}
FIRSTHIT_PURE real intBitsToFloat(integer a)
{
    return std::bit_cast<real>(a);
}

#include "base/real_vectors.inl"

} // namespace firsthit::scalar
