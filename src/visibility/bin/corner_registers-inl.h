// corner_registers-inl.h - loads a corner of several triangles into registers, one triangle a lane.
#if defined(FIRSTHIT_CORNER_REGISTERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_CORNER_REGISTERS_INL_H
#undef FIRSTHIT_CORNER_REGISTERS_INL_H
#else
#define FIRSTHIT_CORNER_REGISTERS_INL_H
#endif

#include <hwy/highway.h>

#include <glm/vec4.hpp>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR

/// One corner of the triangle of each lane. See below for other targets.
template <class D>
class CornerRegisters {
  public:
    using V = hn::Vec<D>;

    HWY_INLINE CornerRegisters(D d, const glm::vec4* corner, const std::uint32_t* index)
        : d_(d),
          corner_(&corner[*index].x)
    {
    }
    HWY_INLINE V x() const { return hn::LoadU(d_, corner_); }
    HWY_INLINE V y() const { return hn::LoadU(d_, corner_ + 1); }
    HWY_INLINE V z() const { return hn::LoadU(d_, corner_ + 2); }
    HWY_INLINE V samples() const { return hn::LoadU(d_, corner_ + 3); }

  private:
    D d_;
    const float* corner_;
};

#else

/// One corner of the triangle of each lane. The four floats of a corner are loaded at once, and
/// transposed in two steps. The constructor does the first step; x(), y(), z() and samples() do the
/// second one for what they return.
template <class D>
class CornerRegisters {
  public:
    using V = hn::Vec<D>;

    /// corner  (V) see EyeMesh::corner
    /// index   the vertex of lane k is index[3 k]
    HWY_INLINE CornerRegisters(
        D d, const glm::vec4* HWY_RESTRICT corner, const std::uint32_t* HWY_RESTRICT index)
        : d_(d)
    {
        const V a = join(d, corner, index), b = join(d, corner, index + 3),
                c = join(d, corner, index + 6), e = join(d, corner, index + 9);
        xy_ab_ = hn::InterleaveLower(d, a, b);
        xy_ce_ = hn::InterleaveLower(d, c, e);
        zs_ab_ = hn::InterleaveUpper(d, a, b);
        zs_ce_ = hn::InterleaveUpper(d, c, e);
    }
    HWY_INLINE V x() const { return lower(xy_ab_, xy_ce_); }
    HWY_INLINE V y() const { return upper(xy_ab_, xy_ce_); }
    HWY_INLINE V z() const { return lower(zs_ab_, zs_ce_); }
    HWY_INLINE V samples() const { return upper(zs_ab_, zs_ce_); }

  private:
    using Pairs = hn::Repartition<double, D>;

    HWY_INLINE V lower(V p, V q) const
    {
        const Pairs pairs;
        return hn::BitCast(
            d_, hn::InterleaveLower(pairs, hn::BitCast(pairs, p), hn::BitCast(pairs, q)));
    }
    HWY_INLINE V upper(V p, V q) const
    {
        const Pairs pairs;
        return hn::BitCast(
            d_, hn::InterleaveUpper(pairs, hn::BitCast(pairs, p), hn::BitCast(pairs, q)));
    }

    /// A register that holds the corners of lanes 0, 4, 8 and 12, or of the first ones of these.
    template <class E>
    static HWY_INLINE hn::Vec<E> join(
        E to, const glm::vec4* HWY_RESTRICT corner, const std::uint32_t* HWY_RESTRICT index)
    {
        if constexpr (hn::MaxLanes(to) == 4) {
            return hn::Load(to, &corner[*index].x);
        } else {
            const hn::Half<E> half;
            const auto first = join(half, corner, index);
            return hn::Combine(to, join(half, corner, index + 3 * hn::MaxLanes(half)), first);
        }
    }

    D d_;
    V xy_ab_, xy_ce_, zs_ab_, zs_ce_;
};

#endif

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif
