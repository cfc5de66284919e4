// machine_kernels.cpp - loops that do one thing as fast as the machine can, for each instruction set.
#include "machine_kernels.h"

#include <type_traits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "machine_kernels.cpp"
#include "base/simd.h"

#include <hwy/cache_control.h>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Chains: latency (3 cycles of a multiplication, 3 of an addition) times steps a cycle (2), and few enough
// for 16 registers.
constexpr int kChains = 12;

// Names of registers for floats and vectors in inline assembly.
#if HWY_ARCH_X86
#define FIRSTHIT_KEEP_FLOAT "+x"
#define FIRSTHIT_KEEP_VECTOR "+v"
#else
#define FIRSTHIT_KEEP_FLOAT "+w"
#define FIRSTHIT_KEEP_VECTOR "+w"
#endif

/// Keeps a value from being left out, in its register.
template <class V>
HWY_INLINE void keep(V& value)
{
#if HWY_TARGET == HWY_SCALAR
    if constexpr (std::is_floating_point_v<decltype(value.raw)>)
        asm volatile("" : FIRSTHIT_KEEP_FLOAT(value.raw));
    else
        asm volatile("" : "+r"(value.raw));
#else
    asm volatile("" : FIRSTHIT_KEEP_VECTOR(value.raw));
#endif
}

#undef FIRSTHIT_KEEP_FLOAT
#undef FIRSTHIT_KEEP_VECTOR

std::uint32_t read(const std::uint8_t* from, std::size_t bytes)
{
    const hn::ScalableTag<std::uint32_t> d;
    const std::size_t step = sizeof(std::uint32_t) * hn::Lanes(d);
    auto a = hn::Zero(d), b = hn::Zero(d), c = hn::Zero(d), e = hn::Zero(d);
    const auto at = [&](std::size_t k) {
        return hn::Load(d, reinterpret_cast<const std::uint32_t*>(from + k));
    };
    for (std::size_t k = 0; k < bytes; k += 4 * step) {
        a = hn::Or(a, at(k));
        b = hn::Or(b, at(k + step));
        c = hn::Or(c, at(k + 2 * step));
        e = hn::Or(e, at(k + 3 * step));
    }
    return hn::GetLane(hn::Or(hn::Or(a, b), hn::Or(c, e)));
}

void write(std::uint8_t* to, std::size_t bytes)
{
    const hn::ScalableTag<std::uint32_t> d;
    const std::size_t step = sizeof(std::uint32_t) * hn::Lanes(d);
    auto value = hn::Set(d, 7u);
    for (std::size_t k = 0; k < bytes; k += 4 * step) {
        keep(value); // no memset
        for (std::size_t part = 0; part < 4; ++part)
            hn::Store(value, d, reinterpret_cast<std::uint32_t*>(to + k + part * step));
    }
}

void stream(std::uint8_t* to, std::size_t bytes)
{
    const hn::ScalableTag<std::uint32_t> d;
    const std::size_t step = sizeof(std::uint32_t) * hn::Lanes(d);
    const auto value = hn::Set(d, 7u);
    for (std::size_t k = 0; k < bytes; k += 4 * step)
        for (std::size_t part = 0; part < 4; ++part)
            hn::Stream(value, d, reinterpret_cast<std::uint32_t*>(to + k + part * step));
    hwy::FlushStream();
}

void copy(const std::uint8_t* from, std::uint8_t* to, std::size_t bytes)
{
    const hn::ScalableTag<std::uint32_t> d;
    const std::size_t step = sizeof(std::uint32_t) * hn::Lanes(d);
    for (std::size_t k = 0; k < bytes; k += 4 * step)
        for (std::size_t part = 0; part < 4; ++part) {
            const std::size_t at = k + part * step;
            auto value = hn::Load(d, reinterpret_cast<const std::uint32_t*>(from + at));
            keep(value); // no memcpy
            hn::Store(value, d, reinterpret_cast<std::uint32_t*>(to + at));
        }
}

/// Runs `step` on each of the chains until there were `count` operations.
template <class D, class Step>
HWY_INLINE double run_chains(
    D d, hn::TFromD<D> seed, double count, double operations, const Step& step)
{
    auto a = hn::Set(d, seed), b = a, c = a, e = a, f = a, g = a;
    auto h = a, i = a, j = a, k = a, l = a, m = a;
    const double each = operations * double(hn::Lanes(d)) * kChains;
    const auto rounds = static_cast<std::uint64_t>(count / each) + 1;
    for (std::uint64_t round = 0; round < rounds; ++round) {
        a = step(a), b = step(b), c = step(c), e = step(e), f = step(f), g = step(g);
        h = step(h), i = step(i), j = step(j), k = step(k), l = step(l), m = step(m);
        keep(a), keep(b), keep(c), keep(e), keep(f), keep(g);
        keep(h), keep(i), keep(j), keep(k), keep(l), keep(m);
    }
    return each * double(rounds);
}

double fused_floats(double count, float seed)
{
    const hn::ScalableTag<float> d;
    const auto factor = hn::Set(d, 0.999f), more = hn::Set(d, 0.001f);
    return run_chains(
        d, seed, count, 2, [&](auto v) HWY_ATTR { return hn::MulAdd(v, factor, more); });
}

double floats(double count, float seed)
{
    const hn::ScalableTag<float> d;
    const auto factor = hn::Set(d, 0.999f), more = hn::Set(d, 0.001f);
    return run_chains(
        d, seed, count, 2, [&](auto v) HWY_ATTR { return hn::Add(hn::Mul(v, factor), more); });
}

double doubles(double count, double seed)
{
    const hn::ScalableTag<double> d;
    const auto factor = hn::Set(d, 0.999), more = hn::Set(d, 0.001);
    return run_chains(
        d, seed, count, 2, [&](auto v) HWY_ATTR { return hn::Add(hn::Mul(v, factor), more); });
}

double products(double count, std::uint64_t seed)
{
    const hn::ScalableTag<std::uint64_t> d;
#if HWY_TARGET == HWY_SCALAR
    const auto factor = hn::Set(d, std::uint64_t(0x9E3779B9));
    return run_chains(d, seed, count, 1, [&](auto v) HWY_ATTR {
        return hn::Set(d, (hn::GetLane(v) & 0xFFFFFFFF) * hn::GetLane(factor));
    });
#else
    const hn::ScalableTag<std::uint32_t> half;
    const auto factor = hn::Set(half, 0x9E3779B9u);
    return run_chains(d, seed, count, 1,
        [&](auto v) HWY_ATTR { return hn::MulEven(hn::BitCast(half, v), factor); });
#endif
}

MachineKernels kernels()
{
    return {read, write, stream, copy, fused_floats, floats, doubles, products};
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(kernels);

MachineKernels machine_kernels()
{
    return HWY_DYNAMIC_DISPATCH(kernels)();
}

} // namespace firsthit
#endif
