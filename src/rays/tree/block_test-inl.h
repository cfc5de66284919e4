// block_test-inl.h - which triangles of a leaf a ray may hit: a filter in float of exact/ray_hit.h.
//
// With p = v0 - o, e1 = v1 - v0, e2 = v2 - v0 and r = d x p, the edge functions are
//
//     edge(v0, v1) = e1 . r      edge(v2, v0) = -e2 . r      edge(v1, v2) = det - the other two
//     det = d . (e1 x e2)        volume = p . (e1 x e2)
//
// Each is a sum of three terms with at most eight roundings of 2^-24, of a size that the largest coordinates P, E1
// and E2 of p, e1 and e2 bound; d is below 2. The error of the first two is below 7 * 12 * 2^-24 P E, with E for E1 or E2,
// that of det below 7 * 12 * 2^-24 E1 E2, that of the third below the sum of these and two roundings,
// 108 * 2^-24 (P E1 + P E2 + E1 E2): this is taken for all three. The volume's error is below 8 * 6 * 2^-24 P E1 E2. What
// denormal numbers lose, also where they are flushed to zero, is below 2^-119 (1 + M)^2 with M >= max(P, E1, E2).
// M is that of the whole tree, seen from the ray's origin. Where it is so large that products might overflow, it is each
// triangle's own, and nothing is certain of those where they still might.
#if defined(FIRSTHIT_RAYS_TREE_BLOCK_TEST_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_RAYS_TREE_BLOCK_TEST_INL_H_
#undef FIRSTHIT_RAYS_TREE_BLOCK_TEST_INL_H_
#else
#define FIRSTHIT_RAYS_TREE_BLOCK_TEST_INL_H_
#endif

#include "rays/tree/slab_test-inl.h"

#include <firsthit/scene.h>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// As many floats as fit, at most the triangles of a block.
using BlockTag = hn::CappedTag<float, kPerLeaf>;
using BlockFloats = hn::Vec<BlockTag>;
inline constexpr int kBlockLanes = int(hn::MaxLanes(BlockTag()));

struct BlockVector {
    BlockFloats x, y, z;
};
HWY_INLINE BlockVector operator-(const BlockVector& a, const BlockVector& b)
{
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE BlockFloats dot(const BlockVector& a, const BlockVector& b)
{
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE BlockVector cross(const BlockVector& a, const BlockVector& b)
{
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)),
        hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
        hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}
HWY_INLINE BlockFloats largest(const BlockVector& a)
{
    return hn::Max(hn::Max(hn::Abs(a.x), hn::Abs(a.y)), hn::Abs(a.z));
}
HWY_INLINE BlockVector broadcast(const glm::vec3& v)
{
    const BlockTag d;
    return {hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)};
}

/// What the filter found of a block. Sizes are absolute values; t is size_of_volume / size_of_det.
struct BlockHits {
    alignas(32) float det[kPerLeaf], det_error[kPerLeaf], volume[kPerLeaf], volume_error[kPerLeaf];
    unsigned possible; // bit k: triangle k is not certainly missed
    unsigned certain;  // bit k: it is certainly hit, and its numbers are good for an interval of t

    /// The interval of the scaled t of a triangle that is certainly hit.
    float low(int k) const
    {
        return std::max(0.0f,
            (volume[k] - volume_error[k]) / (det[k] + det_error[k]) * (1 - 0x1p-20f) - 0x1p-120f);
    }
    float high(int k) const
    {
        return (volume[k] + volume_error[k]) / (det[k] - det_error[k]) * (1 + 0x1p-20f) + 0x1p-120f;
    }
};

class BlockTest {
  public:
    HWY_INLINE BlockTest(const PreparedRay& ray, float largest_coordinate)
        : origin_(broadcast(ray.origin)),
          direction_(broadcast(ray.direction))
    {
        const float most = 2 * (largest_coordinate + largest_of(ray.origin));
        is_huge_ = !(most < kHuge);
        floor_ = kFloor * (1 + most) * (1 + most);
    }

    /// limit  triangles that are certainly hit at a greater scaled t are missed
    HWY_INLINE void test(const TriangleBlock& block, float limit, BlockHits& hits) const
    {
        hits.possible = hits.certain = 0;
        for (int k = 0; k < kPerLeaf; k += kBlockLanes) test_lanes(block, k, limit, hits);
    }

  private:
    HWY_INLINE void test_lanes(
        const TriangleBlock& block, int k, float limit, BlockHits& hits) const
    {
        const BlockTag d;
        const auto corner = [&](int number) -> BlockVector {
            const auto axis = [&](int a) { return hn::Load(d, block.corner[3 * number + a] + k); };
            return {axis(0), axis(1), axis(2)};
        };
        const BlockVector v0 = corner(0), e1 = corner(1) - v0, e2 = corner(2) - v0,
                          p = v0 - origin_;
        const BlockVector n = cross(e1, e2), r = cross(direction_, p);
        const BlockFloats det = dot(direction_, n), volume = dot(p, n), edge01 = dot(e1, r),
                          edge20 = hn::Neg(dot(e2, r)),
                          edge12 = hn::Sub(hn::Sub(det, edge01), edge20);

        const BlockFloats size_p = largest(p), size1 = largest(e1), size2 = largest(e2);
        BlockFloats floor = hn::Set(d, floor_);
        unsigned in_range = (1u << kBlockLanes) - 1;
        if (is_huge_) [[unlikely]] {
            const BlockFloats most = hn::Max(size_p, hn::Max(size1, size2));
            const BlockFloats more = hn::Add(most, hn::Set(d, 1));
            floor = hn::Mul(hn::Set(d, kFloor), hn::Mul(more, more));
            in_range = mask_bits(d, hn::Lt(most, hn::Set(d, kHuge)));
        }
        const BlockFloats size12 = hn::Mul(size1, size2), relative = hn::Set(d, 0x1p-17f);
        const BlockFloats det_error = hn::MulAdd(relative, size12, floor),
                          error = hn::MulAdd(
                              hn::Mul(relative, size_p), hn::Add(size1, size2), det_error),
                          volume_error =
                              hn::MulAdd(hn::Set(d, 0x1p-18f), hn::Mul(size_p, size12), floor);

        const BlockFloats least = hn::Min(hn::Min(edge01, edge12), edge20),
                          greatest = hn::Max(hn::Max(edge01, edge12), edge20);
        const auto some_above = hn::Gt(greatest, error), some_below = hn::Lt(least, hn::Neg(error));
        const auto outside = hn::And(some_above, some_below);
        const auto inside = hn::Or(hn::Gt(least, error), hn::Lt(greatest, hn::Neg(error)));

        const BlockFloats det_size = hn::Abs(det), height = hn::Abs(volume);
        const auto opposite =
            hn::Lt(hn::CopySign(hn::Set(d, 1), hn::Xor(det, volume)), hn::Zero(d));
        const auto signs = hn::And(hn::Gt(det_size, det_error), hn::Gt(height, volume_error));
        const auto too_far = hn::Gt(hn::Sub(height, volume_error),
            hn::Mul(hn::Set(d, limit),
                hn::Mul(hn::Add(det_size, det_error), hn::Set(d, 1 + 0x1p-20f))));
        const auto missed = hn::Or(hn::Or(outside, too_far), hn::And(signs, opposite));
        const hn::RebindToUnsigned<BlockTag> ids;
        const auto there =
            hn::RebindMask(d, hn::Ne(hn::Load(ids, block.triangle + k), hn::Set(ids, kNoItem)));
        const unsigned possible = mask_bits(d, there) & ~(mask_bits(d, missed) & in_range);
        if (possible == 0) return;
        const auto known = hn::And(hn::And(inside, hn::AndNot(opposite, signs)),
            hn::Gt(det_size, hn::Mul(hn::Set(d, 4), det_error)));
        hits.possible |= possible << k;
        hits.certain |= (possible & in_range & mask_bits(d, known)) << k;
        hn::Store(det_size, d, hits.det + k);
        hn::Store(det_error, d, hits.det_error + k);
        hn::Store(height, d, hits.volume + k);
        hn::Store(volume_error, d, hits.volume_error + k);
    }

    static constexpr float kFloor = 0x1p-119f, kHuge = 0x1p38f;

    static float largest_of(const glm::vec3& v)
    {
        return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    }

    BlockVector origin_, direction_;
    float floor_;  // what denormal numbers lose
    bool is_huge_; // it has to be found for each triangle
};

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
