// tiny_list-inl.h - a list of triangles of a kind, which are tested together once there are enough.
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

/// The list, as a structure of arrays. It is read in aligned registers from its start.
struct TinyList {
    using D = hn::CappedTag<float, 16>;
    using Words = hn::RebindToSigned<D>;
    static constexpr int kFull = 64;             // so many triangles are tested together
    static constexpr int kRoom = kFull + 2 * 16; // a register is appended as a whole

    int count = 0;
    alignas(64) std::uint32_t triangle[kRoom];
    alignas(
        64) std::int32_t first[kRoom]; // x | y << 16: the first sample of the box; negative if a
                                       // corner is behind the eye, and the box is not known
    alignas(64) std::int32_t steps[kRoom]; // x | y << 16: the last sample of the box less the first
    alignas(64) float corner[9][kRoom];    // x0 y0 z0 x1 ..., in the mesh's CornerSpace
    alignas(64) std::uint32_t open[kRoom]; // 1: the test was not certain

    /// Removes the first triangles from the list.
    ///
    /// kCorners  whether the list's triangles have been given corners
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

/// One register of the list: triangles number `first` to `first` + `count` - 1. Lanes beyond are
/// ignored.
struct ListRegister {
    TinyList& list;
    int first, count;
};

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif
