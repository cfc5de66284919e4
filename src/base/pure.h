// pure.h - how the functions of src/glsl/ are declared when C++ compiles them.
#pragma once

/// Before each function of the maths text; nothing in GLSL. Inlined always: the arguments are SIMD
/// registers, and a function that was not inlined would pass them through memory.
#define FIRSTHIT_PURE [[gnu::always_inline, maybe_unused]] inline

/// Before variables whose operations GLSL must not fuse or reorder; C++ does neither here.
#define FIRSTHIT_PRECISE
