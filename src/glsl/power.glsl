// power.glsl - logarithm, exponential and power with the same bits on every machine.
//
// The texts of this folder are compiled as GLSL 4.50, where real = float, real3 = vec3, integer =
// int and truth = bool, and as C++, where these types are SIMD registers (base/simd_real-inl.h) or
// scalars (base/scalar_real.h). The functions are pure and never branch on a value that differs
// between lanes.

/// The integer nearest to x, for |x| <= 2^22; halves are rounded to even. Adding 1.5 * 2^23 moves
/// the integer to the low bits of the mantissa.
FIRSTHIT_PURE integer whole_to_integer(real x)
{
    return floatBitsToInt(x + 12582912.0f) - 0x4B400000;
}

/// log2(x) for a normal float x > 0, with a relative error below 3e-7. Undefined for other x (NaN
/// is possible).
FIRSTHIT_PURE real steady_log2(real x)
{
    // x = 2^e m with m in [sqrt(1/2), sqrt(2)): then log2(m) does not cancel e near x = 1.
    integer bits = floatBitsToInt(x);
    integer e = shift_right_23(bits - 0x3F3504F3);
    real m = intBitsToFloat(bits - shift_left_23(e));

    // ln(m) = 2 artanh(s), s = (m - 1) / (m + 1), |s| < 0.1716: terms after s^9 are below 2e-9.
    real s = (m - 1.0f) / (m + 1.0f);
    real z = s * s;
    real series = ((0.320598898f * z + 0.412198583f) * z + 0.577078016f) * z + 0.961796694f;
    return real(e) + s * (series * z + 2.885390082f);
}

/// 2^y for -126 < y < 127, with a relative error below 3e-7.
FIRSTHIT_PURE real steady_exp2(real y)
{
    // 2^y = 2^whole * e^(rest ln 2), |rest| <= 1/2: terms after the 7th power are below 6e-9.
    real whole = floor(y + 0.5f);
    real rest = y - whole;
    real series = ((1.52527338e-5f * rest + 1.54035304e-4f) * rest + 1.33335581e-3f) * rest;
    series = ((series + 9.61812911e-3f) * rest + 5.55041087e-2f) * rest + 2.40226507e-1f;
    series = (series * rest + 6.93147181e-1f) * rest + 1.0f;
    return series * intBitsToFloat(shift_left_23(whole_to_integer(whole) + 127));
}

/// x^exponent for exponent > 0 and x = 0 or normal in (0, 1]. The absolute error is below 1e-6; the
/// relative error is below 3e-6 for results above 1e-6.
FIRSTHIT_PURE real steady_pow(real x, real exponent)
{
    real y = max(exponent * steady_log2(max(x, 1.17549435e-38f)), -126.0f);
    real power = mix(real(0.0f), steady_exp2(y), y > real(-126.0f));
    return mix(real(0.0f), power, x > real(0.0f));
}

/// x^exponent by repeated squaring, for a whole exponent >= 0 that all lanes share. x^0 = 1.
FIRSTHIT_PURE real steady_pow_whole(real x, int exponent)
{
    real power = real(1.0f);
    real square = x;
    for (int rest = exponent; rest > 0; rest >>= 1) {
        if ((rest & 1) != 0) power = power * square;
        square = square * square;
    }
    return power;
}
