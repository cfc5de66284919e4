// ray_tests-inl.h - tests triangles against the rays of a block's samples: is_hit (exact/hit.h), a
// register of samples at a time.
//
// An edge function is e = n . (x, y, 1) with n = a x b. Each component of n has one rounding, since
// products of two floats are exact in double. With the product and two sums each term carries at
// most four, so e is within 4 u (|n.x x| + |n.y y| + |n.z|), u = 2^-53, apart from terms of higher
// order. kEdgeSlack stands for twice that, with the largest |x| and |y| of the tile; its own
// roundings are a few u of it.
#if defined(FIRSTHIT_HITS_RAY_TESTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_HITS_RAY_TESTS_INL_H_
#undef FIRSTHIT_HITS_RAY_TESTS_INL_H_
#else
#define FIRSTHIT_HITS_RAY_TESTS_INL_H_
#endif

#include "hits/block_samples.h"
#include "hits/item_runs-inl.h"
#include "visibility/bin/eye_mesh.h"
#include "visibility/triangle_planes-inl.h"
#include "visibility/tile_items.h"

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

constexpr int kRayTests = 64; // tests of a batch
constexpr double kEdgeSlack = 8 * kUlp;

/// A triangle and the samples of a block that are tested against it.
struct RayTest {
    std::uint32_t triangle;
    std::uint32_t block;
    std::uint64_t samples;
};

/// A batch of tests and its triangles, as a structure of arrays.
struct RayTests {
    int count = 0;
    RayTest test[kRayTests];
    alignas(64) float corner[9][kRayTests];   // x0 y0 z0 x1 ...
    alignas(64) double edge[3][3][kRayTests]; // x, y and z of n of each edge; e is positive inside
    alignas(64) double error[3][kRayTests];   // bounds of the error of e anywhere in the tile
    std::uint64_t usable = 0;                 // bit i: triangle i can be hit
    std::uint64_t certain = 0; // bit i: on which side of triangle i the eye is, is certain

    Corners corners(int i) const
    {
        return {glm::vec3(corner[0][i], corner[1][i], corner[2][i]),
            glm::vec3(corner[3][i], corner[4][i], corner[5][i]),
            glm::vec3(corner[6][i], corner[7][i], corner[8][i])};
    }
};

/// The direction of a sample's ray, in eye space.
inline glm::vec3 direction_of(const TileItems& tile, std::uint32_t block, int sample)
{
    return tile.block_rays(int(block)).direction(block_x(sample), block_y(sample));
}

/// Loads the triangles of the tests and sets them up for the tile's rays.
HWY_INLINE void set_up_tests(const EyeMesh& mesh, const TileItems& tile, RayTests& tests)
{
    for (int i = 0; i < tests.count; ++i) {
        const glm::uvec3 index = mesh.index[tests.test[i].triangle];
        for (int k = 0; k < 3; ++k) {
            const glm::vec4& p = mesh.corner[index[k]];
            tests.corner[3 * k][i] = p.x;
            tests.corner[3 * k + 1][i] = p.y;
            tests.corner[3 * k + 2][i] = p.z;
        }
    }
    const hn::CappedTag<double, 8> d;
    const hn::Rebind<float, decltype(d)> f;
    using V = hn::Vec<decltype(d)>;
    const glm::dvec2 reach = tile.rays.reach(tile.size, tile.size);
    const V most_x = hn::Set(d, reach.x), most_y = hn::Set(d, reach.y);
    tests.usable = tests.certain = 0;
    for (int i = 0; i < tests.count; i += int(hn::Lanes(d))) {
        auto farthest = hn::Zero(f);
        auto known = hn::Eq(farthest, farthest);
        V c[9];
        for (int axis = 0; axis < 9; ++axis) {
            const auto corner = hn::Load(f, tests.corner[axis] + i);
            c[axis] = hn::PromoteTo(d, corner);
            known = hn::And(known, hn::Lt(hn::Abs(corner), hn::Set(f, kFarthest)));
        }
        const Planes<V> p =
            planes_of<V>({c[0], c[1], c[2]}, {c[3], c[4], c[5]}, {c[6], c[7], c[8]});
        tests.usable |= bits_of(f, known) << i;
        tests.certain |=
            bits_of(d, hn::Gt(hn::Abs(p.volume), hn::Mul(hn::Set(d, kEdgeSlack), p.volume_size)))
            << i;
        const V side = hn::CopySign(hn::Set(d, 1.0), p.volume);
        for (int k = 0; k < 3; ++k) {
            const Vector3<V>& n = p.edge[k];
            hn::Store(hn::Mul(n.x, side), d, tests.edge[k][0] + i);
            hn::Store(hn::Mul(n.y, side), d, tests.edge[k][1] + i);
            hn::Store(hn::Mul(n.z, side), d, tests.edge[k][2] + i);
            const V size =
                hn::Add(hn::Add(hn::Mul(hn::Abs(n.x), most_x), hn::Mul(hn::Abs(n.y), most_y)),
                    hn::Abs(n.z));
            hn::Store(hn::Mul(size, hn::Set(d, kEdgeSlack)), d, tests.error[k] + i);
        }
    }
}

/// The samples of test i whose rays hit its triangle, a bit each.
HWY_INLINE std::uint64_t hit_samples(
    const RayTests& tests, int i, const TileItems& tile, Effort& effort)
{
    const RayTest& test = tests.test[i];
    if (!(tests.usable >> i & 1)) return 0;
    std::uint64_t hits = 0, open = test.samples;
    if (tests.certain >> i & 1) {
        const hn::CappedTag<double, 8> d;
        const hn::Rebind<float, decltype(d)> f;
        const int lanes = int(hn::Lanes(d));
        const LatticeTile rays = tile.block_rays(int(test.block));
        const auto x0 = hn::Set(d, double(rays.x0)), y0 = hn::Set(d, double(rays.y0));
        const std::uint64_t all = (std::uint64_t(1) << lanes) - 1;
        std::uint64_t missed = 0;
        for (std::uint64_t rest = test.samples; rest;) {
            const int first = std::countr_zero(rest) / lanes * lanes; // sample of a register
            rest &= ~(all << first);
            const auto x = hn::Add(x0, hn::PromoteTo(d, hn::Load(f, kBlockSamplesXY.x + first)));
            const auto y = hn::Add(y0, hn::PromoteTo(d, hn::Load(f, kBlockSamplesXY.y + first)));
            const auto edge = [&](int k) {
                return hn::Add(hn::Add(hn::Mul(hn::Set(d, tests.edge[k][0][i]), x),
                                   hn::Mul(hn::Set(d, tests.edge[k][1][i]), y)),
                    hn::Set(d, tests.edge[k][2][i]));
            };
            const auto e0 = edge(0), e1 = edge(1), e2 = edge(2);
            const auto b0 = hn::Set(d, tests.error[0][i]), b1 = hn::Set(d, tests.error[1][i]),
                       b2 = hn::Set(d, tests.error[2][i]);
            const auto inside = hn::And(hn::Gt(e0, b0), hn::And(hn::Gt(e1, b1), hn::Gt(e2, b2)));
            const auto outside = hn::Or(
                hn::Lt(e0, hn::Neg(b0)), hn::Or(hn::Lt(e1, hn::Neg(b1)), hn::Lt(e2, hn::Neg(b2))));
            hits |= bits_of(d, inside) << first;
            missed |= bits_of(d, outside) << first;
        }
        hits &= test.samples;
        open &= ~(hits | missed);
    }
    for (; open; open &= open - 1) { // seldom
        const int sample = std::countr_zero(open);
        if (is_hit(tests.corners(i), direction_of(tile, test.block, sample), effort))
            hits |= std::uint64_t(1) << sample;
    }
    return hits;
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
