// cast_rays.cpp - single rays through a RayTree, the nearest children first.
#include "rays/tree/cast_rays.h"

#include "exact/cutout_opacity.h"
#include "rays/tree/cast_answers.h"

#include <algorithm>
#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rays/tree/cast_rays.cpp"
#include "base/simd.h"

#include "rays/tree/block_test-inl.h"
#include "rays/tree/slab_test-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// A child that a ray still has to visit.
struct StackedChild {
    std::uint32_t child; // TreeChild::value; without initialisers, as the stack is large
    float entry;         // scaled t where the ray enters it
};
inline constexpr int kStack = (kWide - 1) * kDeepest + kWide;

/// One ray's way through the tree.
template <class Answer>
class Traversal {
  public:
    HWY_INLINE Traversal(const CastTarget& target, const PreparedRay& ray, Answer& answer)
        : target_(target),
          ray_(ray),
          answer_(answer),
          slabs_(ray),
          blocks_(ray, target.tree.largest_coordinate())
    {
    }

    HWY_INLINE void run()
    {
        const TreeNode* const nodes = target_.tree.nodes().data();
        const TriangleBlock* const blocks = target_.tree.blocks().data();
        float limit = with_slack(std::min(ray_.last, answer_.limit()));
        int depth = 0;
        StackedChild next{0, 0}; // the root
        while (true) {
            if (next.entry <= limit) {
                bool found = true;
                while (!TreeChild{next.child}.is_leaf() && found)
                    found = descend(nodes[next.child], limit, next, depth);
                if (found) {
                    if (test(blocks[TreeChild{next.child}.index()])) return;
                    limit = with_slack(std::min(ray_.last, answer_.limit()));
                }
            }
            if (depth == 0) return;
            next = stack_[--depth];
        }
    }

  private:
    /// Goes on with the nearest child that the ray may meet; the others are put on the stack, the farthest first.
    /// returns  false where there is none
    HWY_INLINE bool descend(const TreeNode& node, float limit, StackedChild& next, int& depth)
    {
        alignas(32) float entry[kWide];
        unsigned bits = slabs_.meet(node, limit, entry);
        if (bits == 0) return false;
        const auto take = [&] {
            const int k = std::countr_zero(bits);
            bits &= bits - 1;
            return StackedChild{node.child[k].value, entry[k]};
        };
        next = take();
        if (bits == 0) return true;
        const int first = depth;
        while (bits != 0) {
            StackedChild other = take();
            if (other.entry < next.entry) std::swap(other, next);
            int place = depth++;
            for (; place > first && stack_[place - 1].entry < other.entry; --place)
                stack_[place] = stack_[place - 1];
            stack_[place] = other;
        }
        return true;
    }

    /// returns  whether the ray is done
    HWY_INLINE bool test(const TriangleBlock& block)
    {
        BlockHits hits;
        blocks_.test(block, std::min(ray_.last, answer_.limit()), hits);
        for (unsigned bits = hits.possible; bits != 0; bits &= bits - 1) {
            const int k = std::countr_zero(bits);
            Candidate candidate{&block, k, block.triangle[k]};
            if (hits.certain >> k & 1) {
                candidate.low = hits.low(k);
                candidate.high = hits.high(k);
                if (candidate.low > answer_.limit()) continue;
            }
            if (take(candidate, hits.certain >> k & 1)) return true;
        }
        return false;
    }

    /// Decides what the filter left open.
    bool take(Candidate& candidate, bool is_certain)
    {
        const Ray& ray = *ray_.ray;
        if (candidate.triangle == ray.skip) return false;
        if (!is_certain) {
            Effort effort;
            const Corners corners = candidate.corners();
            if (!is_hit(ray, corners, effort)) return false;
            const DepthInterval t = depth_interval(ray, corners);
            candidate.low = float_below(t.low * ray_.scale);
            candidate.high = float_above(t.high * ray_.scale);
        }
        if (ray_.has_range &&
            !(candidate.low >= ray_.first_inside && candidate.high <= ray_.last_inside)) {
            Effort effort;
            const Corners corners = candidate.corners();
            if (compare_depth(ray, corners, ray.t_min, effort) < 0 ||
                compare_depth(ray, corners, ray.t_max, effort) > 0)
                return false;
        }
        if (target_.cutouts.has(candidate.triangle)) {
            const auto [u, v] = rounded_barycentrics(ray, candidate.corners());
            if (!is_solid_at(target_.scene, candidate.triangle, u, v, kSeenOpacity)) return false;
        }
        return answer_.take(ray, candidate);
    }

    const CastTarget& target_;
    const PreparedRay& ray_;
    Answer& answer_;
    SlabTest slabs_;
    BlockTest blocks_;
    StackedChild stack_[kStack];
};

template <class Answer>
HWY_INLINE void cast(const CastTarget& target, const Ray& ray, Answer& answer)
{
    if (target.tree.empty() || !usable(ray)) return;
    const PreparedRay prepared(ray, target.tree.largest_coordinate());
    Traversal<Answer>(target, prepared, answer).run();
}

void nearest(const CastTarget& target, std::span<const Ray> rays, std::span<RayHit> hits)
{
    for (std::size_t k = 0; k < rays.size(); ++k) {
        NearestAnswer answer;
        cast(target, rays[k], answer);
        hits[k] = {};
        if (answer.best().block == nullptr) continue;
        hits[k] = rounded_hit(rays[k], answer.best().corners());
        hits[k].triangle = answer.best().triangle;
    }
}

void any(const CastTarget& target, std::span<const Ray> rays, std::span<std::uint8_t> is_hit)
{
    for (std::size_t k = 0; k < rays.size(); ++k) {
        AnyAnswer answer;
        cast(target, rays[k], answer);
        is_hit[k] = answer.found();
    }
}

void count_hits(const CastTarget& target, std::span<const Ray> rays, std::span<std::uint32_t> count)
{
    for (std::size_t k = 0; k < rays.size(); ++k) {
        CountAnswer answer;
        cast(target, rays[k], answer);
        count[k] = answer.count();
    }
}

void all(const CastTarget& target, std::span<const Ray> rays, std::span<std::uint32_t> count,
    std::vector<RayHit>& hits)
{
    AllAnswer answer;
    for (std::size_t k = 0; k < rays.size(); ++k) {
        answer.clear();
        cast(target, rays[k], answer);
        const std::vector<Candidate>& sorted = answer.sorted(rays[k]);
        count[k] = std::uint32_t(sorted.size());
        for (const Candidate& candidate : sorted) {
            hits.push_back(rounded_hit(rays[k], candidate.corners()));
            hits.back().triangle = candidate.triangle;
        }
    }
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(nearest);
HWY_EXPORT(any);
HWY_EXPORT(count_hits);
HWY_EXPORT(all);

void cast_nearest(const CastTarget& target, std::span<const Ray> rays, std::span<RayHit> hits)
{
    HWY_DYNAMIC_DISPATCH(nearest)(target, rays, hits);
}

void cast_any(const CastTarget& target, std::span<const Ray> rays, std::span<std::uint8_t> is_hit)
{
    HWY_DYNAMIC_DISPATCH(any)(target, rays, is_hit);
}

void cast_count(const CastTarget& target, std::span<const Ray> rays, std::span<std::uint32_t> count)
{
    HWY_DYNAMIC_DISPATCH(count_hits)(target, rays, count);
}

void cast_all(const CastTarget& target, std::span<const Ray> rays, std::span<std::uint32_t> count,
    std::vector<RayHit>& hits)
{
    HWY_DYNAMIC_DISPATCH(all)(target, rays, count, hits);
}

} // namespace firsthit
#endif
