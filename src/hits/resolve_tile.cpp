// resolve_tile.cpp - where exactly does each sample's ray hit its item?
//
// Neighbouring samples mostly see the same triangle: a triangle is fetched and set up once for each
// block that it is seen in, and then meets only the registers of its samples.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "hits/resolve_tile.cpp"
#include "base/simd.h"

#include "hits/item_runs-inl.h"
#include "hits/resolve_tile.h"
#include "visibility/set_up-inl.h"

#include <firsthit/scene.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

using Doubles = hn::CappedTag<double, 8>;
using Floats = hn::Rebind<float, Doubles>;

constexpr int kRuns = 64; // set up together

/// Planes of a batch of runs' triangles, structure of arrays.
struct RunBatch {
    alignas(64) float corner[9][kRuns];
    alignas(64) double n[3][kRuns];     // det = n . d
    alignas(64) double edge1[3][kRuns]; // u = edge1 . d / det
    alignas(64) double edge2[3][kRuns];
    alignas(64) double volume[kRuns]; // t = volume / det
    alignas(64) double volume_size[kRuns];

    Corners corners(std::size_t i) const
    {
        return {glm::vec3(corner[0][i], corner[1][i], corner[2][i]),
            glm::vec3(corner[3][i], corner[4][i], corner[5][i]),
            glm::vec3(corner[6][i], corner[7][i], corner[8][i])};
    }
};

void fill_misses(int block, const HitPlaces& places)
{
    const int first = block * kBlockSamples;
    std::fill_n(places.t + first, kBlockSamples, std::numeric_limits<float>::infinity());
    std::fill_n(places.u + first, kBlockSamples, 0.0f);
    std::fill_n(places.v + first, kBlockSamples, 0.0f);
}

/// Finds the runs of all blocks, and marks the samples that are in none. Returns how many.
std::size_t find_runs(const ItemTile& items, const HitPlaces& places)
{
    HitRun* runs = places.run;
    HitRun* next = runs;
    for (int block = 0; block < items.blocks(); ++block) {
        const std::uint32_t* item = items.item.data() + block * kBlockSamples;
        std::uint64_t rest = ~samples_with(item, kNoItem);
        if (~rest) fill_misses(block, places);
        while (rest) {
            const std::uint32_t id = item[std::countr_zero(rest)];
            const std::uint64_t samples = samples_with(item, id);
            *next++ = {id, std::uint16_t(block), 0, samples};
            rest &= ~samples;
        }
    }
    return std::size_t(next - runs);
}

void set_up_runs(const ViewMemory& view, std::span<const HitRun> runs, RunBatch& batch)
{
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const glm::uvec3 index = view.index[runs[i].item];
        for (int k = 0; k < 3; ++k) {
            const glm::vec4& p = view.corner[index[k]];
            batch.corner[3 * k][i] = p.x;
            batch.corner[3 * k + 1][i] = p.y;
            batch.corner[3 * k + 2][i] = p.z;
        }
    }
    const Doubles d;
    const Floats f;
    using V = hn::Vec<Doubles>;
    for (std::size_t i = 0; i < runs.size(); i += hn::Lanes(d)) {
        const auto load = [&](int axis) {
            return hn::PromoteTo(d, hn::Load(f, batch.corner[axis] + i));
        };
        const Vector3<V> v0{load(0), load(1), load(2)}, v1{load(3), load(4), load(5)},
            v2{load(6), load(7), load(8)};
        const Planes<V> p = planes_of(v0, v1, v2);
        const auto store = [&](const Vector3<V>& v, double(&to)[3][kRuns]) {
            hn::Store(v.x, d, to[0] + i);
            hn::Store(v.y, d, to[1] + i);
            hn::Store(v.z, d, to[2] + i);
        };
        store(p.n, batch.n);
        store(p.edge[1], batch.edge1);
        store(p.edge[2], batch.edge2);
        hn::Store(p.volume, d, batch.volume + i);
        hn::Store(p.volume_size, d, batch.volume_size + i);
    }
}

/// Samples whose double depth lies outside the triangle's: its determinant lost too many digits.
HWY_NOINLINE void repair_hits(const Corners& corners, const ItemTile& items, int offset,
    std::uint64_t samples, const float* x, const float* y, const HitPlaces& places)
{
    for (; samples; samples &= samples - 1) {
        const int lane = std::countr_zero(samples);
        const glm::vec3 d{items.x0 + x[lane], items.y0 + y[lane], 1.0f};
        const auto [u, v] = exact_barycentrics(corners, d);
        const auto at = std::size_t(offset + lane);
        places.t[at] = float(1 / exact_inverse_depth(corners, d));
        places.u[at] = float(std::clamp(u, 0.0, 1.0));
        places.v[at] = float(std::clamp(v, 0.0, 1.0));
    }
}

void resolve_run(const RunBatch& batch, std::size_t i, const HitRun& run, const ItemTile& items,
    const float* sample_x, const float* sample_y, const HitPlaces& places)
{
    const Doubles d;
    const Floats f;
    const int lanes = int(hn::Lanes(d));
    const int block_x = int(run.block) % items.blocks_x() * kBlock;
    const int block_y = int(run.block) / items.blocks_x() * kBlock;
    const auto x0 = hn::Set(d, double(items.x0) + block_x),
               y0 = hn::Set(d, double(items.y0) + block_y);
    const auto plane = [&](const double(&n)[3][kRuns], auto x, auto y) {
        return hn::Add(hn::Add(hn::Mul(hn::Set(d, n[0][i]), x), hn::Mul(hn::Set(d, n[1][i]), y)),
            hn::Set(d, n[2][i]));
    };
    const float z[3] = {batch.corner[2][i], batch.corner[5][i], batch.corner[8][i]};
    const auto nearest = hn::Set(f, std::min({z[0], z[1], z[2]}) * (1 - 0x1p-20f));
    const auto farthest = hn::Set(f, std::max({z[0], z[1], z[2]}) * (1 + 0x1p-20f));
    const auto zero = hn::Zero(f), one = hn::Set(f, 1.0f);

    const std::uint64_t all = (std::uint64_t(1) << lanes) - 1;
    for (std::uint64_t rest = run.samples; rest;) {
        const int k = std::countr_zero(rest) / lanes * lanes; // first sample of a register
        const std::uint64_t samples = rest >> k & all;
        rest &= ~(all << k);
        std::uint8_t bytes[8];
        std::memcpy(bytes, &samples, 8);
        const auto mask = hn::LoadMaskBits(f, bytes);
        const auto x = hn::Add(x0, hn::PromoteTo(d, hn::Load(f, sample_x + k)));
        const auto y = hn::Add(y0, hn::PromoteTo(d, hn::Load(f, sample_y + k)));
        const auto inverse = hn::Div(hn::Set(d, 1.0), plane(batch.n, x, y));
        const auto t = hn::DemoteTo(f, hn::Mul(hn::Set(d, batch.volume[i]), inverse));
        const auto u = hn::DemoteTo(f, hn::Mul(plane(batch.edge1, x, y), inverse));
        const auto v = hn::DemoteTo(f, hn::Mul(plane(batch.edge2, x, y), inverse));
        const int offset = int(run.block) * kBlockSamples + k;
        const auto keep = [&](auto value, float* to) {
            float* at = to + offset;
            hn::Store(hn::IfThenElse(mask, value, hn::Load(f, at)), f, at);
        };
        const auto weight = [&](auto w) { return hn::Min(hn::Max(w, zero), one); };
        keep(t, places.t);
        keep(weight(u), places.u);
        keep(weight(v), places.v);
        const auto plausible = hn::And(hn::Ge(t, nearest), hn::Le(t, farthest));
        if (!hn::AllTrue(f, hn::Or(plausible, hn::Not(mask)))) [[unlikely]] {
            const std::uint64_t suspect = bits_of(f, hn::AndNot(plausible, mask));
            float x_in_tile[8], y_in_tile[8];
            for (int lane = 0; lane < lanes; ++lane) {
                x_in_tile[lane] = float(block_x) + sample_x[k + lane];
                y_in_tile[lane] = float(block_y) + sample_y[k + lane];
            }
            repair_hits(batch.corners(i), items, offset, suspect, x_in_tile, y_in_tile, places);
        }
    }
}

/// On which side of its plane each run's triangle has the eye.
void find_sides(const RunBatch& batch, std::span<HitRun> runs)
{
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const double volume = batch.volume[i];
        int side = volume > 0 ? 1 : -1;
        if (std::abs(volume) <= 8 * kUlp * batch.volume_size[i]) [[unlikely]] {
            Effort effort;
            side = volume_sign(batch.corners(i), effort);
        }
        runs[i].eye_side = std::int16_t(side);
    }
}

std::size_t resolve(const ViewMemory& view, const ItemTile& items, const HitPlaces& places)
{
    alignas(64) float sample_x[kBlockSamples], sample_y[kBlockSamples];
    for (int k = 0; k < kBlockSamples; ++k) {
        sample_x[k] = float(block_x(k));
        sample_y[k] = float(block_y(k));
    }
    const std::size_t count = find_runs(items, places);
    RunBatch batch{};
    for (std::size_t first = 0; first < count; first += kRuns) {
        const std::span<HitRun> runs(
            places.run + first, std::min<std::size_t>(kRuns, count - first));
        set_up_runs(view, runs, batch);
        find_sides(batch, runs);
        for (std::size_t i = 0; i < runs.size(); ++i)
            resolve_run(batch, i, runs[i], items, sample_x, sample_y, places);
    }
    return count;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(resolve);

void resize(HitMemory& memory, int tile_size, std::size_t tiles)
{
    memory.samples = std::size_t(tile_size) * std::size_t(tile_size);
    memory.run.resize(tiles * memory.samples);
    memory.item.resize(tiles * memory.samples);
    for (Buffer<float>* plane : {&memory.t, &memory.u, &memory.v})
        plane->resize(tiles * memory.samples);
}

HitTile resolve_tile(const ViewMemory& view, const ItemTile& items, const HitPlaces& places)
{
    const std::size_t runs = HWY_DYNAMIC_DISPATCH(resolve)(view, items, places);
    HitTile hits;
    hits.size = items.size;
    hits.frame.x0 = items.x0;
    hits.frame.y0 = items.y0;
    hits.frame.inv_f = float(1 / view.pencil.f);
    hits.frame.eye = glm::vec3(view.pencil.eye);
    hits.frame.world_from_eye = glm::mat3(view.pencil.world_from_axes);
    hits.runs = std::span<const HitRun>(places.run, runs);
    std::copy_n(items.item.data(), std::size_t(items.size) * std::size_t(items.size), places.item);
    hits.item = places.item;
    hits.t = places.t;
    hits.u = places.u;
    hits.v = places.v;
    return hits;
}

} // namespace firsthit
#endif
