// pure.h - macros for the declarations in src/glsl/ when C++ compiles them.
#pragma once

/// Precedes each function; GLSL defines it as nothing. Always inlined: the arguments are SIMD
/// registers, and a call that is not inlined would pass them through memory.
#define FIRSTHIT_PURE [[gnu::always_inline, maybe_unused]] inline

/// Precedes variables whose operations GLSL must not fuse or reorder. C++ does neither, with the
/// compile flags used here.
#define FIRSTHIT_PRECISE
