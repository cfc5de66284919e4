// tiny_list-inl.h - triangles that wait until there are enough of a kind.
#if defined(FIRSTHIT_TINY_LIST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_TINY_LIST_INL_H
#undef FIRSTHIT_TINY_LIST_INL_H
#else
#define FIRSTHIT_TINY_LIST_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Structure of arrays. Registers of it begin at whole registers from the start.
struct TinyList {
    using D = hn::CappedTag<float, 16>;
    using Words = hn::RebindToSigned<D>;
    static constexpr int kFull = 64, kRoom = kFull + 2 * 16; // a register more, stored whole

    int count = 0;
    alignas(64) std::uint32_t triangle[kRoom];
    alignas(64) std::int32_t first[kRoom]; // x | y << 16: the box's first sample; < 0: behind
    alignas(64) std::int32_t steps[kRoom]; // x | y << 16: samples after the first
    alignas(64) float corner[9][kRoom];    // x0 y0 z0 x1 ..., see CornerSpace
    alignas(64) std::uint32_t open[kRoom]; // what came of them, 1: not certain

    /// Takes away the first triangles.
    /// kCorners  whether the list has been given corners
    template <bool kCorners>
    void drop(int triangles)
    {
        count -= triangles;
        const auto move = [&](auto* array) { std::copy_n(array + triangles, count, array); };
        move(triangle);
        move(first);
        move(steps);
        if constexpr (kCorners)
            for (auto& axis : corner) move(axis);
    }
};

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif
