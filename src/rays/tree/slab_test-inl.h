// slab_test-inl.h - which boxes of a node a ray may meet.
//
// A box is never missed by rounding. The plane distance (plane - origin) * inverse has at most three roundings, so
// if the ray enters a box before it leaves it, then the computed entry is at most the computed exit times
// (1 + 2^-21) plus a number that covers products which are denormal or flushed to zero.
//
// source  Ize 2013, "Robust BVH Ray Traversal", Journal of Computer Graphics Techniques 2(2)
#if defined(FIRSTHIT_RAYS_TREE_SLAB_TEST_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_RAYS_TREE_SLAB_TEST_INL_H_
#undef FIRSTHIT_RAYS_TREE_SLAB_TEST_INL_H_
#else
#define FIRSTHIT_RAYS_TREE_SLAB_TEST_INL_H_
#endif

#include "rays/tree/prepared_ray.h"
#include "rays/tree/ray_tree.h"

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// As many floats as fit, at most the children of a node.
using TreeTag = hn::CappedTag<float, kWide>;
using TreeFloats = hn::Vec<TreeTag>;
inline constexpr int kTreeLanes = int(hn::MaxLanes(TreeTag()));

/// Bit k: lane k of at most eight is true.
template <class Tag>
HWY_INLINE unsigned mask_bits(Tag tag, hn::Mask<Tag> mask)
{
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(tag, mask, bits);
    return bits[0] & ((1u << hn::MaxLanes(tag)) - 1);
}

/// An exit or limit with what Ize's rule adds.
HWY_INLINE float with_slack(float t)
{
    return t * (1 + 0x1p-21f) + 0x1p-120f;
}

class SlabTest {
  public:
    HWY_INLINE explicit SlabTest(const PreparedRay& ray) : first_(hn::Set(TreeTag(), ray.first))
    {
        for (int axis = 0; axis < 3; ++axis) {
            near_row_[axis] = ray.near_row[axis];
            far_row_[axis] = ray.far_row[axis];
            near_[axis] = hn::Set(TreeTag(), ray.slab_near[axis]);
            far_[axis] = hn::Set(TreeTag(), ray.slab_far[axis]);
            inverse_[axis] = hn::Set(TreeTag(), ray.inverse[axis]);
        }
    }

    /// Bit k: the ray may meet the box of child k at a scaled t of at most `limit`, which has its slack.
    /// entry  receives where it enters each, aligned
    HWY_INLINE unsigned meet(const TreeNode& node, float limit, float* HWY_RESTRICT entry) const
    {
        const TreeTag d;
        const TreeFloats most = hn::Set(d, limit), grow = hn::Set(d, 1 + 0x1p-21f),
                         least = hn::Set(d, 0x1p-120f);
        unsigned bits = 0;
        for (int k = 0; k < kWide; k += kTreeLanes) {
            const auto distance = [&](int row, const TreeFloats& slab, const TreeFloats& inverse) {
                return hn::Mul(hn::Sub(hn::Load(d, node.bound[row] + k), slab), inverse);
            };
            const TreeFloats enter = hn::Max(hn::Max(distance(near_row_[0], near_[0], inverse_[0]),
                                                 distance(near_row_[1], near_[1], inverse_[1])),
                hn::Max(distance(near_row_[2], near_[2], inverse_[2]), first_));
            const TreeFloats leave = hn::Min(hn::Min(distance(far_row_[0], far_[0], inverse_[0]),
                                                 distance(far_row_[1], far_[1], inverse_[1])),
                distance(far_row_[2], far_[2], inverse_[2]));
            hn::Store(enter, d, entry + k);
            const TreeFloats end = hn::Min(hn::MulAdd(leave, grow, least), most);
            bits |= mask_bits(d, hn::Le(enter, end)) << k;
        }
        return bits;
    }

  private:
    int near_row_[3], far_row_[3];
    TreeFloats near_[3], far_[3], inverse_[3], first_;
};

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
