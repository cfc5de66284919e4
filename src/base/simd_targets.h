// simd_targets.h - the instruction sets that kernels are compiled for.
//
// On x86: SCALAR (one lane, where the compiler breaks EMU128: g++ before 12.3), SSE4, AVX2, AVX3.
// Left out: SSSE3, because all machines of interest have SSE4; and SVE, because its registers have
// no size at compile time and so cannot be members of a struct (see simd_real-inl.h).
//
// Every file that includes Highway includes this one first, so that all files use the same targets.
#pragma once

#if defined(HWY_HIGHWAY_INCLUDED) && !defined(HWY_DISABLED_TARGETS)
#error "include base/simd_targets.h or base/simd.h before Highway's headers"
#endif

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)

#include <hwy/targets.h>
