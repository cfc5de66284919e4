// simd.h - Highway, set up so that a kernel file is compiled once for each instruction set.
//
// The pattern, in full (this header must be seen once for each target: no #pragma once):
//
//     #include "shade/shade_tile.h"       // own header and other ordinary headers first
//
//     #undef HWY_TARGET_INCLUDE
//     #define HWY_TARGET_INCLUDE "shade/shade_tile.cpp" // this file itself, relative to src/
//     #include "base/simd.h"
//     #include "base/simd_real-inl.h"     // then headers that hold kernels, *-inl.h
//
//     HWY_BEFORE_NAMESPACE();
//     namespace firsthit {
//     namespace HWY_NAMESPACE {           // N_AVX2, ...
//     void shade(...) { ... }             // the kernel, compiled for that target
//     } // namespace HWY_NAMESPACE
//     } // namespace firsthit
//     HWY_AFTER_NAMESPACE();
//
//     #if HWY_ONCE                        // compiled once, not once for each target
//     namespace firsthit {
//     HWY_EXPORT(shade);                  // a table of the kernel's variants
//     void shade_tile(...) { HWY_DYNAMIC_DISPATCH(shade)(...); }
//     } // namespace firsthit
//     #endif
//
// Rules that give the same bits on every target: use only + - * / sqrt floor and integers; no
// MulAdd (fused on some targets only), no Approximate..., no sum over lanes (its order depends on
// their number).
#include "base/simd_targets.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>
