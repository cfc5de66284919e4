// sample_normals-inl.h - normals of a register of samples that each see another triangle.
//
// If triangles are about as small as samples, it costs more to prepare what the samples of a
// triangle share than that saves. Here 4, 8 or 16 triangles are loaded and computed at once: a
// corner is one load of 16 bytes, and the registers are transposed as 4x4 matrices.
#if defined(FIRSTHIT_SHADE_SAMPLE_NORMALS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SHADE_SAMPLE_NORMALS_INL_H_
#undef FIRSTHIT_SHADE_SAMPLE_NORMALS_INL_H_
#else
#define FIRSTHIT_SHADE_SAMPLE_NORMALS_INL_H_
#endif

#include "hits/run_lanes-inl.h"
#include "shade/block_attributes-inl.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// For each sample of a block: the corners of its triangle, and the triangle's normal towards the
/// eye. Samples without a triangle keep the values of an earlier block.
struct SampleCorners {
    std::uint32_t last;    // number of the world's last vertex
    bool has_last = false; // some triangle so far has that vertex
    alignas(64) std::uint32_t vertex[3][kBlockSamples] = {};
    alignas(64) float to_eye[3][kBlockSamples] = {};

    explicit SampleCorners(std::size_t vertices) : last(static_cast<std::uint32_t>(vertices - 1)) {}

    /// lanes  a bit for each entry to set: the run's samples, or the run's number in its block
    HWY_INLINE void set(const glm::uvec3& corner, const HitRun& run, std::uint64_t lanes)
    {
        has_last |= corner.x == last || corner.y == last || corner.z == last;
        for (; lanes != 0; lanes &= lanes - 1) {
            const int k = std::countr_zero(lanes);
            vertex[0][k] = corner.x;
            vertex[1][k] = corner.y;
            vertex[2][k] = corner.z;
            for (int axis = 0; axis < 3; ++axis) to_eye[axis][k] = run.plane[axis];
        }
    }
};

/// Loads from[vertex[0]], from[vertex[1]], ..., one for each lane of a register.
///
/// kWhole  no load may reach beyond the 12 bytes of its vector: needed if the array's last vector
///         is among them. Otherwise 16 bytes are loaded
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
    // Each 128-bit lane of the result holds one vector: those of lanes `lane`, lane + 4, lane + 8,
    // ...
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

/// Vector version of Interpolated<glm::vec3> (run_setup.h): one triangle in each lane.
struct LaneNormals {
    real3 at0, to1, to2;
};

/// The normals of entries [first, first + kLanes) of `corners`, computed in the same steps as
/// run_normal (run_setup.h).
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

/// Interpolates normals at the samples [first, first + kLanes) of the block and stores them.
HWY_INLINE void store_normals(const LaneNormals& normals, const HitTile& hits, std::size_t block,
    int first, BlockAttributes& attributes)
{
    const auto& [at0, to1, to2] = normals;
    const std::size_t at = block * kBlockSamples + std::size_t(first);
    const real u = load(hits.u + at), v = load(hits.v + at);
    store(at0.x + (u * to1.x + v * to2.x), attributes.normal[0] + first);
    store(at0.y + (u * to1.y + v * to2.y), attributes.normal[1] + first);
    store(at0.z + (u * to1.z + v * to2.z), attributes.normal[2] + first);
}

/// The runs of a block, and a bit for each of its samples that light reaches.
struct ReachedRuns {
    std::span<const HitRun> runs;
    std::uint64_t samples;
};

/// Of a block's samples that are reached, each with the corners of its own.
template <bool kWhole>
HWY_INLINE void sample_normals(const ShadeArrays& arrays, const HitTile& hits,
    const ReachedRuns& reached, const SampleCorners& corners, BlockAttributes& attributes)
{
    for (int first = 0; first < kBlockSamples; first += kLanes)
        if (lane_bits(reached.samples, first) != 0)
            store_normals(lane_normals<kWhole>(arrays, corners, first), hits, reached.runs[0].block,
                first, attributes);
}

#if HWY_TARGET == HWY_AVX3
/// The same for at most kMostRunLanes runs. `corners` has an entry for each run.
template <bool kWhole>
HWY_INLINE void sample_run_normals(const ShadeArrays& arrays, const HitTile& hits,
    const ReachedRuns& reached, const SampleCorners& corners, BlockAttributes& attributes)
{
    static_assert(kMostRunLanes == kLanes);
    const LaneNormals of_run = lane_normals<kWhole>(arrays, corners, 0);
    const RunLanes lanes(reached.runs);
    for (int first = 0; first < kBlockSamples; first += kLanes) {
        if (lane_bits(reached.samples, first) == 0) continue;
        const auto pick = [&](const real3& v) {
            const auto one = [&](real a) {
                return real(hn::Vec<RealTag>{lanes.of_samples(first, a.lanes.raw)});
            };
            return real3(one(v.x), one(v.y), one(v.z));
        };
        store_normals({pick(of_run.at0), pick(of_run.to1), pick(of_run.to2)}, hits,
            reached.runs[0].block, first, attributes);
    }
}
#endif

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
