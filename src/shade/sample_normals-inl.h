// sample_normals-inl.h - normals of a register of samples, each with a triangle of its own.
//
// Where triangles are about as small as samples, working out what the samples of a triangle share
// is more than what it spares. Here 4, 8 or 16 triangles are fetched and worked out at once: a
// corner is one load of 16 bytes, and registers are transposed as 4x4 matrices.
#if defined(FIRSTHIT_SHADE_SAMPLE_NORMALS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SHADE_SAMPLE_NORMALS_INL_H_
#undef FIRSTHIT_SHADE_SAMPLE_NORMALS_INL_H_
#else
#define FIRSTHIT_SHADE_SAMPLE_NORMALS_INL_H_
#endif

#include "shade/block_surface-inl.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// The corners of each sample's triangle, in a block. Samples that have none keep what they had in
/// the blocks before.
struct SampleCorners {
    std::uint32_t last;    // of all vertices
    bool has_last = false; // it was set in some block
    alignas(64) std::uint32_t vertex[3][kBlockSamples] = {};

    explicit SampleCorners(std::size_t vertices) : last(static_cast<std::uint32_t>(vertices - 1)) {}

    HWY_INLINE void set(const glm::uvec3& corner, std::uint64_t samples)
    {
        has_last |= corner.x == last || corner.y == last || corner.z == last;
        for (; samples != 0; samples &= samples - 1) {
            const int k = std::countr_zero(samples);
            vertex[0][k] = corner.x;
            vertex[1][k] = corner.y;
            vertex[2][k] = corner.z;
        }
    }
};

/// from[vertex[0]], from[vertex[1]], ... of a register.
///
/// kWhole  a load may not reach beyond the 12 bytes of its vector: the last of its array is there
template <bool kWhole>
HWY_INLINE real3 fetch_vectors(const glm::vec3* from, const std::uint32_t* vertex)
{
#if HWY_TARGET == HWY_SCALAR
    const glm::vec3& v = from[vertex[0]];
    return real3(v.x, v.y, v.z);
#else
    const hn::CappedTag<float, 4> four;
    const auto one = [&](int lane) {
        const float* v = &from[vertex[lane]].x;
        if constexpr (!kWhole) return hn::LoadU(four, v);
        alignas(16) const float copy[4] = {v[0], v[1], v[2], 0};
        return hn::Load(four, copy);
    };
    // Each 128-bit part has the vector of a lane, four lanes on in the next.
    const auto every_fourth = [&](int lane) {
        if constexpr (kLanes == 4) {
            return one(lane);
        } else {
            const hn::CappedTag<float, 8> eight;
            const auto low = hn::Combine(eight, one(lane + 4), one(lane));
            if constexpr (kLanes == 8)
                return low;
            else
                return hn::Combine(
                    RealTag(), hn::Combine(eight, one(lane + 12), one(lane + 8)), low);
        }
    };
    const RealTag d;
    const hn::Repartition<double, RealTag> pairs;
    const auto v0 = every_fourth(0), v1 = every_fourth(1), v2 = every_fourth(2),
               v3 = every_fourth(3);
    const auto xy01 = hn::BitCast(pairs, hn::InterleaveLower(d, v0, v1)); // x0 x1 y0 y1
    const auto xy23 = hn::BitCast(pairs, hn::InterleaveLower(d, v2, v3));
    const auto z01 = hn::BitCast(pairs, hn::InterleaveUpper(d, v0, v1));
    const auto z23 = hn::BitCast(pairs, hn::InterleaveUpper(d, v2, v3));
    return real3(real(hn::BitCast(d, hn::InterleaveLower(pairs, xy01, xy23))),
        real(hn::BitCast(d, hn::InterleaveUpper(pairs, xy01, xy23))),
        real(hn::BitCast(d, hn::InterleaveLower(pairs, z01, z23))));
#endif
}

/// The flip of run_normal (run_setup.h), in the same steps.
HWY_INLINE real flip_to_eye(
    const glm::vec3& eye, const real3& p0, const real3& p1, const real3& p2, const real3& sum)
{
    const hn::CappedTag<double, 8> d;
    const hn::Rebind<float, decltype(d)> f;
    using V = hn::Vec<decltype(d)>;
    alignas(64) float in[12][kLanes], flip[kLanes];
    const auto keep = [&](int row, const real3& v) {
        store(v.x, in[row]);
        store(v.y, in[row + 1]);
        store(v.z, in[row + 2]);
    };
    keep(0, p0);
    keep(3, p1);
    keep(6, p2);
    keep(9, sum);
    for (int lane = 0; lane < kLanes; lane += int(hn::Lanes(d))) {
        const auto at = [&](int row) { return hn::PromoteTo(d, hn::Load(f, in[row] + lane)); };
        const V p[3] = {at(0), at(1), at(2)};
        const V a[3] = {hn::Sub(at(3), p[0]), hn::Sub(at(4), p[1]), hn::Sub(at(5), p[2])};
        const V b[3] = {hn::Sub(at(6), p[0]), hn::Sub(at(7), p[1]), hn::Sub(at(8), p[2])};
        const V n[3] = {hn::Sub(hn::Mul(a[1], b[2]), hn::Mul(b[1], a[2])),
            hn::Sub(hn::Mul(a[2], b[0]), hn::Mul(b[2], a[0])),
            hn::Sub(hn::Mul(a[0], b[1]), hn::Mul(b[0], a[1]))};
        const auto with_n = [&](V x, V y, V z) {
            return hn::Add(hn::Add(hn::Mul(n[0], x), hn::Mul(n[1], y)), hn::Mul(n[2], z));
        };
        const auto from_eye = [&](int axis) {
            return hn::Sub(p[axis], hn::Set(d, double(eye[axis])));
        };
        const V n_p0 = with_n(from_eye(0), from_eye(1), from_eye(2));
        const V along = with_n(at(9), at(10), at(11));
        const V one = hn::Set(d, 1.0);
        const V side = hn::IfThenElse(hn::Gt(n_p0, hn::Zero(d)), hn::Neg(one), one);
        const V sign = hn::IfThenElse(hn::Lt(hn::Mul(along, side), hn::Zero(d)), hn::Neg(one), one);
        hn::Store(hn::DemoteTo(f, sign), f, flip + lane);
    }
    return load(flip);
}

/// Of the samples [first, first + kLanes) of the block, into the surface.
template <bool kWhole>
HWY_INLINE void sample_normals(const ShadeArrays& arrays, const HitTile& hits, std::size_t block,
    const SampleCorners& corners, int first, BlockSurface& surface)
{
    const auto fetch = [&](const glm::vec3* from, int corner) {
        return fetch_vectors<kWhole>(from, corners.vertex[corner] + first);
    };
    const real3 n0 = fetch(arrays.normal, 0), n1 = fetch(arrays.normal, 1),
                n2 = fetch(arrays.normal, 2);
    const real flip = flip_to_eye(hits.frame.eye, fetch(arrays.position, 0),
        fetch(arrays.position, 1), fetch(arrays.position, 2), (n0 + n1) + n2);
    const real3 at0 = n0 * flip, to1 = (n1 - n0) * flip, to2 = (n2 - n0) * flip;
    const std::size_t at = block * kBlockSamples + std::size_t(first);
    const real u = load(hits.u + at), v = load(hits.v + at);
    store(at0.x + (u * to1.x + v * to2.x), surface.normal[0] + first);
    store(at0.y + (u * to1.y + v * to2.y), surface.normal[1] + first);
    store(at0.z + (u * to1.z + v * to2.z), surface.normal[2] + first);
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
