// collect_hits.cpp - turns the hits of a tile into samples of a light's faces.
//
// Most tiles lie on a single face, which is guessed first and whose samples are written directly.
// Hits on other faces are kept as points, which project_points_to_face then handles face by face.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow/exact/collect_hits.cpp"
#include "base/simd.h"

#include "hits/hit_position-inl.h"
#include "hits/hit_position.h"
#include "hits/spot_cone-inl.h"
#include "irregular/mesh/face_samples-inl.h"
#include "shadow/exact/collect_hits.h"
#include "shadow/exact/to_light-inl.h"

#include <algorithm>
#include <bit>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

/// The receivers (exact/shadow_ray.h) of one register of samples.
struct LaneReceivers {
    real3 away;
    real margin;
};

/// The receivers of a block's samples. Undefined for samples that are in no run.
class BlockReceivers {
  public:
    HWY_INLINE void start(std::span<const FacingRun> runs)
    {
        runs_ = runs;
        if (runs.size() <= kFew) return;
        for (const FacingRun& run : runs)
            for (std::uint64_t rest = run.samples; rest; rest &= rest - 1)
                std::memcpy(of_[std::countr_zero(rest)], run.receiver, sizeof run.receiver);
    }

    HWY_INLINE LaneReceivers of(int first) const
    {
        LaneReceivers lanes;
        if (runs_.size() > kFew) {
            hn::LoadInterleaved4(RealTag(), of_[first], lanes.away.x.lanes, lanes.away.y.lanes,
                lanes.away.z.lanes, lanes.margin.lanes);
            return lanes;
        }
        lanes = {real3(runs_[0].receiver[0], runs_[0].receiver[1], runs_[0].receiver[2]),
            runs_[0].receiver[3]};
        for (const FacingRun& run : runs_.subspan(1)) {
            const truth there = truth_of_bits(lane_bits(run.samples, first));
            lanes.away.x = mix(lanes.away.x, run.receiver[0], there);
            lanes.away.y = mix(lanes.away.y, run.receiver[1], there);
            lanes.away.z = mix(lanes.away.z, run.receiver[2], there);
            lanes.margin = mix(lanes.margin, run.receiver[3], there);
        }
        return lanes;
    }

  private:
    static constexpr std::size_t kFew = 3 * kLanes; // up to so many runs, blending each is faster

    std::span<const FacingRun> runs_;
    alignas(64) float of_[kBlockSamples][4] = {};
};

/// Vector version of lifted() (exact/shadow_ray.h), with the same bits.
HWY_INLINE real3 lifted(const PencilSpace& space, real3 d, const LaneReceivers& receivers)
{
    const auto size = [](real v) { return hn::Abs(v.lanes); };
    const real largest(hn::Max(hn::Max(size(d.x), size(d.y)), size(d.z)));
    const real margin = real(kShadowMargin) * (real(2.0f) * largest + real(space.reach));
    return d + receivers.away * (real(0.5f) * (margin + receivers.margin));
}

using Ids = hn::Vec<hn::RebindToUnsigned<RealTag>>;

/// first, first + 1, ... Faster than Highway's Iota, which inserts lane by lane where its start is
/// not a constant.
HWY_INLINE Ids ids_from(std::uint32_t first)
{
    alignas(64) static constexpr std::uint32_t kNumbers[16] = {
        0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    const hn::RebindToUnsigned<RealTag> du;
    return hn::Add(hn::Set(du, first), hn::Load(du, kNumbers));
}

/// Appends the chosen lanes to the chunk. Writes a whole register; entries past `count` are garbage
/// that the next call overwrites. (CompressStore would write only the chosen lanes, but is very
/// slow on some processors.)
HWY_INLINE void add_points(const real3& p, Ids id, truth chosen, PointChunk& chunk)
{
    const RealTag d;
    const hn::RebindToUnsigned<RealTag> du;
    const auto keep = [&](real v, Buffer<float>& to) {
        hn::StoreU(hn::Compress(v.lanes, chosen.lanes), d, to.data() + chunk.count);
    };
    keep(p.x, chunk.x), keep(p.y, chunk.y), keep(p.z, chunk.z);
    hn::StoreU(
        hn::Compress(id, hn::RebindMask(du, chosen.lanes)), du, chunk.id.data() + chunk.count);
    chunk.count += hn::CountTrue(d, chosen.lanes);
}

/// Calls f(points, ids, chosen) for each register that has hits of the runs, in order of samples,
/// and fills in `reached`. The points are lifted and in the light's space.
template <class F>
HWY_INLINE void for_points(const CollectWork& work, std::span<std::uint64_t> reached, const F& f)
{
    const PencilSpace& space = work.mesh.space;
    std::fill(reached.begin(), reached.end(), std::uint64_t(0));
    BlockReceivers receivers;
    for (std::size_t run = 0, end; run < work.runs.size(); run = end) {
        const std::uint32_t block = work.runs[run].block;
        std::uint64_t samples = 0;
        for (end = run; end < work.runs.size() && work.runs[end].block == block; ++end)
            samples |= work.runs[end].samples;
        receivers.start(work.runs.subspan(run, end - run));
        const BlockRays rays = block_rays(work.hits, block);
        for (int first = 0; first < kBlockSamples; first += kLanes) {
            std::uint64_t lanes = lane_bits(samples, first);
            if (lanes == 0) continue;
            const std::size_t at = std::size_t(block) * kBlockSamples + std::size_t(first);
            const real3 p = hit_positions(rays, first, load(work.hits.t + at));
            const real3 q = to_light(space, p);
            if (work.cone) {
                const glm::vec3& lamp = space.lamp;
                const real3 from = space.distance > 0 ? p - real3(lamp.x, lamp.y, lamp.z) : q;
                lanes &= bits_of_truth(in_cone(*work.cone, from));
                if (lanes == 0) continue;
            }
            reached[block] |= lanes << first;
            f(lifted(space, q, receivers.of(first)), ids_from(work.first_id + std::uint32_t(at)),
                truth_of_bits(lanes));
        }
    }
}

void collect_chunk(const CollectWork& work, std::span<std::uint64_t> reached, PointChunk& chunk)
{
    chunk.count = 0;
    for_points(work, reached,
        [&](const real3& p, Ids id, truth chosen) { add_points(p, id, chosen, chunk); });
}

/// The face that most of the hits probably lie on: the wide face if there is one, else the face of
/// a sample in the middle of the runs.
int likely_face(const CollectWork& work)
{
    if (work.mesh.wide_face >= 0) return work.mesh.wide_face;
    const FacingRun& run = work.runs[work.runs.size() / 2];
    const int k = std::countr_zero(run.samples);
    const std::uint32_t blocks_x = std::uint32_t(work.hits.size / kBlock);
    const float x = float(run.block % blocks_x * kBlock) + float(block_x(k)),
                y = float(run.block / blocks_x * kBlock) + float(block_y(k));
    const float t = work.hits.t[run.block * kBlockSamples + std::uint32_t(k)];
    const glm::vec3 d =
        firsthit::to_light(work.mesh.space, firsthit::hit_position(work.hits.rays, x, y, t));
    int axis = std::abs(d.y) > std::abs(d.x) ? 1 : 0;
    if (std::abs(d.z) > std::abs(d[axis])) axis = 2;
    return 2 * axis + (d[axis] < 0);
}

template <int kAxis>
SamplePatch collect_face(const CollectWork& work, float sign, const SampleRoom& room,
    std::span<std::uint64_t> reached, PointChunk& others)
{
    const RealTag d;
    const bool wide = work.mesh.wide_face >= 0;
    SampleWriter writer(room.samples.data(), room.first);
    others.count = 0;
    for_points(work, reached, [&](const real3& p, Ids id, truth chosen) {
        const auto usable = hn::And(is_usable(p).lanes, chosen.lanes);
        auto on = usable;
        if constexpr (kAxis != kParallel)
            on = hn::And(
                on, wide ? on_wide_face<kAxis>(p, sign).lanes : on_face<kAxis>(p, sign).lanes);
        writer.add<kAxis>(p, sign, id, {on});
        if constexpr (kAxis == kParallel) return;
        const auto other = hn::AndNot(on, usable);
        if (!hn::AllFalse(d, other)) add_points(p, id, {other}, others);
    });
    return {{room.first, writer.next() - room.first}, writer.bounds()};
}

void collect(const CollectWork& work, const SampleRoom& room, std::span<std::uint64_t> reached,
    FacePatches& patches, PointChunk& others)
{
    patches = {};
    if (work.runs.empty()) {
        std::fill(reached.begin(), reached.end(), std::uint64_t(0));
        return;
    }
    const bool directional = work.mesh.space.directional;
    const int number = directional ? 0 : likely_face(work);
    const CubeFace face = cube_face(directional, number);
    const auto collect_on = directional        ? collect_face<kParallel>
                            : face.axis_c == 0 ? collect_face<0>
                            : face.axis_c == 1 ? collect_face<1>
                                               : collect_face<2>;
    const SamplePatch part = collect_on(work, face.sign, room, reached, others);
    if (others.count > 0)
        project_points_to_face(
            work.mesh, others, room.first + part.range.count, room.samples, patches);
    if (part.range.count > 0) patches[std::size_t(number)] = part;
}

void remove(const std::uint8_t* shadowed, std::span<std::uint64_t> words)
{
    const hn::CappedTag<std::uint8_t, kBlockSamples> d;
    for (std::uint64_t& word : words) {
        if (word != 0) {
            std::uint64_t dark = 0;
            for (std::size_t k = 0; k < kBlockSamples; k += hn::Lanes(d)) {
                std::uint8_t bits[8] = {};
                hn::StoreMaskBits(d, hn::Ne(hn::LoadU(d, shadowed + k), hn::Zero(d)), bits);
                std::uint64_t some;
                std::memcpy(&some, bits, sizeof some);
                dark |= some << k;
            }
            word &= ~dark;
        }
        shadowed += kBlockSamples;
    }
}

void unpack(std::span<const std::uint64_t> words, float* floats)
{
    for (const std::uint64_t word : words)
        for (int first = 0; first < kBlockSamples; first += kLanes, floats += kLanes)
            store(mix(real(0.0f), real(1.0f), truth_of_bits(lane_bits(word, first))), floats);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(collect);
HWY_EXPORT(collect_chunk);
HWY_EXPORT(remove);
HWY_EXPORT(unpack);

void collect_hits(const CollectWork& work, const SampleRoom& room, std::span<std::uint64_t> reached,
    FacePatches& patches, PointChunk& spare)
{
    HWY_DYNAMIC_DISPATCH(collect)(work, room, reached, patches, spare);
}

void collect_points(const CollectWork& work, std::span<std::uint64_t> reached, PointChunk& chunk)
{
    HWY_DYNAMIC_DISPATCH(collect_chunk)(work, reached, chunk);
}

void remove_shadowed(const std::uint8_t* shadowed, std::span<std::uint64_t> words)
{
    HWY_DYNAMIC_DISPATCH(remove)(shadowed, words);
}

void unpack_bits(std::span<const std::uint64_t> words, float* floats)
{
    HWY_DYNAMIC_DISPATCH(unpack)(words, floats);
}

} // namespace firsthit
#endif
