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

#include "hits/run_lanes-inl.h"
#include "shade/block_surface-inl.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// The corners of each sample's triangle, and its normal towards the eye, in a block. Samples that have none keep what they had in
/// the blocks before.
struct SampleCorners {
    std::uint32_t last;    // of all vertices
    bool has_last = false; // it was set in some block
    alignas(64) std::uint32_t vertex[3][kBlockSamples] = {};
    alignas(64) float to_eye[3][kBlockSamples] = {};

    explicit SampleCorners(std::size_t vertices) : last(static_cast<std::uint32_t>(vertices - 1)) {}

    /// places  a bit for each: the run's samples, or its number
    HWY_INLINE void set(const glm::uvec3& corner, const HitRun& run, std::uint64_t places)
    {
        has_last |= corner.x == last || corner.y == last || corner.z == last;
        for (; places != 0; places &= places - 1) {
            const int k = std::countr_zero(places);
            vertex[0][k] = corner.x;
            vertex[1][k] = corner.y;
            vertex[2][k] = corner.z;
            for (int axis = 0; axis < 3; ++axis) to_eye[axis][k] = run.plane[axis];
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

/// As Interpolated<glm::vec3> (run_setup.h), a triangle a lane.
struct LaneNormals {
    real3 at0, to1, to2;
};

/// Of the triangles number first to first + kLanes - 1, in the steps of run_normal (run_setup.h).
template <bool kWhole>
HWY_INLINE LaneNormals lane_normals(
    const ShadeArrays& arrays, const SampleCorners& corners, int first)
{
    const auto fetch = [&](int corner) {
        return fetch_vectors<kWhole>(arrays.normal, corners.vertex[corner] + first);
    };
    const real3 n0 = fetch(0), n1 = fetch(1), n2 = fetch(2);
    const real3 to_eye(load(corners.to_eye[0] + first), load(corners.to_eye[1] + first),
        load(corners.to_eye[2] + first));
    const real flip = mix(real(1.0f), real(-1.0f), dot((n0 + n1) + n2, to_eye) < real(0.0f));
    return {n0 * flip, (n1 - n0) * flip, (n2 - n0) * flip};
}

/// At the samples [first, first + kLanes) of the block, into the surface.
HWY_INLINE void store_normals(const LaneNormals& normals, const HitTile& hits, std::size_t block,
    int first, BlockSurface& surface)
{
    const auto& [at0, to1, to2] = normals;
    const std::size_t at = block * kBlockSamples + std::size_t(first);
    const real u = load(hits.u + at), v = load(hits.v + at);
    store(at0.x + (u * to1.x + v * to2.x), surface.normal[0] + first);
    store(at0.y + (u * to1.y + v * to2.y), surface.normal[1] + first);
    store(at0.z + (u * to1.z + v * to2.z), surface.normal[2] + first);
}

/// Of a block's samples that are reached, each with the corners of its own.
template <bool kWhole>
HWY_INLINE void sample_normals(const ShadeArrays& arrays, const HitTile& hits, std::size_t block,
    std::uint64_t reached, const SampleCorners& corners, BlockSurface& surface)
{
    for (int first = 0; first < kBlockSamples; first += kLanes)
        if (lane_bits(reached, first) != 0)
            store_normals(
                lane_normals<kWhole>(arrays, corners, first), hits, block, first, surface);
}

#if HWY_TARGET == HWY_AVX3
/// The same, of runs that are few enough for RunLanes, each with the corners of its number.
template <bool kWhole>
HWY_INLINE void sample_run_normals(const ShadeArrays& arrays, const HitTile& hits,
    std::span<const HitRun> runs, std::uint64_t reached, const SampleCorners& corners,
    BlockSurface& surface)
{
    static_assert(kMostRunLanes == kLanes);
    const LaneNormals of_run = lane_normals<kWhole>(arrays, corners, 0);
    const RunLanes lanes(runs);
    for (int first = 0; first < kBlockSamples; first += kLanes) {
        if (lane_bits(reached, first) == 0) continue;
        const auto pick = [&](const real3& v) {
            const auto one = [&](real a) {
                return real(hn::Vec<RealTag>{lanes.of_samples(first, a.lanes.raw)});
            };
            return real3(one(v.x), one(v.y), one(v.z));
        };
        store_normals({pick(of_run.at0), pick(of_run.to1), pick(of_run.to2)}, hits, runs[0].block,
            first, surface);
    }
}
#endif

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
