// machine_kernels.h - loops that do one thing as fast as the machine can, for each instruction set.
#pragma once

#include <cstddef>
#include <cstdint>

namespace firsthit {

/// All take and leave what they need to not be left out by the compiler. Sizes are in bytes, multiples of
/// 1024; pointers are aligned to 64.
struct MachineKernels {
    std::uint32_t (*read)(const std::uint8_t* from, std::size_t bytes);
    void (*write)(std::uint8_t* to, std::size_t bytes);
    void (*stream)(std::uint8_t* to, std::size_t bytes); // past the caches
    void (*copy)(const std::uint8_t* from, std::uint8_t* to, std::size_t bytes);

    /// Do `count` operations or a few more, in chains that do not wait for each other; return how many. An
    /// operation is that of one lane: a multiplication, an addition, or (fused) both, which count as two.
    double (*fused_floats)(double count, float seed);
    double (*floats)(double count, float seed); // a multiplication, then an addition
    double (*doubles)(double count, double seed);
    double (*products)(double count, std::uint64_t seed); // 32 x 32 bits to 64
};

/// The kernels of the best instruction set that Highway may choose now.
MachineKernels machine_kernels();

} // namespace firsthit
