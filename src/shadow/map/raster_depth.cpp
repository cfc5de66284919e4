// raster_depth.cpp - rasterises the depth of one tile of a shadow map.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow/map/raster_depth.cpp"
#include "base/simd.h"

#include "shadow/map/raster_depth.h"
#include "visibility/raster/sample_registers-inl.h"
#include "visibility/triangle_planes-inl.h"
#include "visibility/bin/triangle_box.h"

#include <firsthit/scene.h>

#include <hwy/cache_control.h>

#include <algorithm>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

using Wide = hn::CappedTag<double, 8>;
using Narrow = hn::Rebind<float, Wide>;

/// A value of an edge function's c that no slope can make positive inside a tile (see kFlattest in
/// visibility/bin/project.cpp).
constexpr double kOutside = -0x1p100;

/// w clamped to [least, greatest]; NaN gives `least`.
template <class D>
HWY_INLINE hn::Vec<D> clamp_w(D, hn::Vec<D> w, hn::Vec<D> least, hn::Vec<D> greatest)
{
    return hn::Min(hn::IfThenElse(hn::Gt(w, least), w, least), greatest);
}

/// Adds to an edge function's c the bound of its float rounding error inside the triangle's box
/// (kEdgeError times its largest value there), so that every sample inside is >= 0 in float too.
HWY_INLINE hn::Vec<Wide> with_error(
    DepthTile& tile, int i, hn::Vec<Wide> gx, hn::Vec<Wide> gy, hn::Vec<Wide> c)
{
    const Wide d;
    const hn::Rebind<std::int32_t, Wide> w;
    const auto extent_x = hn::PromoteTo(d, hn::Load(w, tile.x1 + i));
    const auto extent_y = hn::PromoteTo(d, hn::Load(w, tile.y1 + i));
    const auto size = hn::Add(
        hn::Abs(c), hn::Add(hn::Mul(extent_x, hn::Abs(gx)), hn::Mul(extent_y, hn::Abs(gy))));
    return hn::Add(c, hn::Mul(size, hn::Set(d, double(kEdgeError))));
}

/// Computes edges and depth of one register of the batch, starting at triangle i, from projected
/// corners. Computed in double and rounded once.
void set_up_flat(DepthTile& tile, int i, float x0, float y0)
{
    const Wide d;
    const Narrow f;
    using V = hn::Vec<Wide>;
    const auto load = [&](int axis) {
        return hn::PromoteTo(d, hn::Load(f, tile.corner[axis] + i));
    };
    const auto store = [&](V v, float* to) { hn::Store(hn::DemoteTo(f, v), f, to + i); };
    V x[3], y[3];
    for (int k = 0; k < 3; ++k) {
        x[k] = hn::Sub(load(3 * k), hn::Set(d, double(x0)));
        y[k] = hn::Sub(load(3 * k + 1), hn::Set(d, double(y0)));
    }
    const V w0 = load(2), w1 = hn::Sub(load(5), w0), w2 = hn::Sub(load(8), w0);
    V gx[3], gy[3], c[3];
    for (int k = 0; k < 3; ++k) {
        const int p = (k + 1) % 3, q = (k + 2) % 3;
        gx[k] = hn::Sub(y[p], y[q]);
        gy[k] = hn::Sub(x[q], x[p]);
        c[k] = hn::Sub(hn::Mul(x[p], y[q]), hn::Mul(y[p], x[q]));
    }
    // Twice the area. Exact but for the last sum: the corners' differences are exact, or lose only
    // digits that float cannot represent.
    const V area = hn::Sub(hn::Mul(gx[1], gy[2]), hn::Mul(gy[1], gx[2]));
    const auto edge_on = hn::Eq(area, hn::Zero(d));
    const V sense = hn::And(area, hn::Set(d, -0.0));
    for (int k = 0; k < 3; ++k) {
        const auto inwards = [&](V v) { return hn::Xor(v, sense); };
        const V at = with_error(tile, i, gx[k], gy[k], inwards(c[k]));
        store(inwards(gx[k]), tile.gx[k]);
        store(inwards(gy[k]), tile.gy[k]);
        // A triangle seen edge-on covers no sample.
        store(hn::IfThenElse(edge_on, hn::Set(d, kOutside), at), tile.c[k]);
    }
    const V inverse_area = hn::Div(hn::Set(d, 1.0), hn::IfThenElse(edge_on, hn::Set(d, 1.0), area));
    const auto slope = [&](const V(&e)[3]) {
        return hn::Mul(hn::Add(hn::Mul(e[1], w1), hn::Mul(e[2], w2)), inverse_area);
    };
    store(slope(gx), tile.wx);
    store(slope(gy), tile.wy);
    store(hn::Add(w0, slope(c)), tile.wc);

    // Clamps the depths to those of the corners, which rounding could exceed.
    const auto w = [&](int axis) { return hn::Load(f, tile.corner[axis] + i); };
    hn::Store(hn::Min(w(2), hn::Min(w(5), w(8))), f, tile.least_w + i);
    hn::Store(hn::Max(w(2), hn::Max(w(5), w(8))), f, tile.greatest_w + i);
}

/// The same from corners in eye space, of which some are behind the eye.
void set_up_careful(DepthTile& tile, int i, float x0, float y0)
{
    const Wide d;
    const Narrow f;
    using V = hn::Vec<Wide>;
    const auto load = [&](int axis) {
        return hn::PromoteTo(d, hn::Load(f, tile.corner[axis] + i));
    };
    const Vector3<V> v0{load(0), load(1), load(2)}, v1{load(3), load(4), load(5)},
        v2{load(6), load(7), load(8)};
    const Planes<V> p = planes_of(v0, v1, v2);
    const V ox = hn::Set(d, double(x0)), oy = hn::Set(d, double(y0)), one = hn::Set(d, 1.0);
    const auto at_first = [&](const Vector3<V>& n) {
        return hn::Add(hn::Add(hn::Mul(n.x, ox), hn::Mul(n.y, oy)), n.z);
    };
    const auto store = [&](V v, float* to) { hn::Store(hn::DemoteTo(f, v), f, to + i); };

    const auto edge_on = hn::Eq(p.volume, hn::Zero(d));
    for (int k = 0; k < 3; ++k) {
        const Vector3<V>& n = p.edge[k];
        const V at = at_first(n);
        // Scaled so that |e| <= 1 over the tile, to stay in the range of float.
        const V side = hn::Set(d, double(tile.size));
        const V size = hn::Add(hn::Abs(at), hn::Mul(side, hn::Add(hn::Abs(n.x), hn::Abs(n.y))));
        const V scale = hn::Div(hn::CopySign(one, p.volume), size);
        const V gx = hn::Mul(n.x, scale), gy = hn::Mul(n.y, scale);
        store(gx, tile.gx[k]);
        store(gy, tile.gy[k]);
        const V c = with_error(tile, i, gx, gy, hn::Mul(at, scale));
        // A triangle seen edge-on covers no sample.
        store(hn::IfThenElse(edge_on, hn::Set(d, kOutside), c), tile.c[k]);
    }
    const V inverse_volume = hn::Div(one, p.volume);
    store(hn::Mul(p.n.x, inverse_volume), tile.wx);
    store(hn::Mul(p.n.y, inverse_volume), tile.wy);
    store(hn::Mul(at_first(p.n), inverse_volume), tile.wc);

    // Clamps the depths to those of the corners, which rounding could exceed.
    const auto z = [&](int axis) { return hn::Load(f, tile.corner[axis] + i); };
    const auto nearest = hn::Min(z(2), hn::Min(z(5), z(8)));
    const auto farthest = hn::Max(z(2), hn::Max(z(5), z(8)));
    const auto single = hn::Set(f, 1.0f);
    hn::Store(hn::Div(single, farthest), f, tile.least_w + i);
    hn::Store(hn::IfThenElse(hn::Gt(nearest, hn::Zero(f)), hn::Div(single, nearest),
                  hn::Set(f, std::numeric_limits<float>::infinity())),
        f, tile.greatest_w + i);
}

/// Computes 1/t at the four corners of triangle boxes of at most 2x2 texels: 0 where the triangle
/// does not cover the texel or the box is larger. Decides most triangles of a fine mesh, several at
/// once. A box of one column or row has its texels twice, which does not change a maximum.
void set_up_tiny(DepthTile& tile, int i)
{
    const hn::CappedTag<float, 8> f;
    const hn::RebindToSigned<decltype(f)> w;
    const auto load = [&](const float* from) { return hn::Load(f, from + i); };
    const auto coordinate = [&](const std::int32_t* from) {
        return hn::ConvertTo(f, hn::Load(w, from + i));
    };
    const auto x0 = coordinate(tile.x0), y0 = coordinate(tile.y0);
    const auto x1 = coordinate(tile.x1), y1 = coordinate(tile.y1);
    const auto one = hn::Set(f, 1.0f);
    const auto tiny = hn::And(hn::Le(hn::Sub(x1, x0), one), hn::Le(hn::Sub(y1, y0), one));
    hn::Store(hn::VecFromMask(w, hn::RebindMask(w, tiny)), w, tile.tiny + i);
    if (hn::AllFalse(f, tiny)) return;
    const auto least_w = load(tile.least_w), greatest_w = load(tile.greatest_w);
    for (int k = 0; k < 4; ++k) {
        const auto x = k & 1 ? x1 : x0, y = k & 2 ? y1 : y0;
        const auto at = [&](const float* gx, const float* gy, const float* c) {
            return hn::Add(hn::Mul(load(gx), x), hn::Add(hn::Mul(load(gy), y), load(c)));
        };
        const auto edge = [&](int e) { return at(tile.gx[e], tile.gy[e], tile.c[e]); };
        const auto least = hn::Min(edge(0), hn::Min(edge(1), edge(2)));
        const auto inside = hn::And(tiny, hn::Ge(least, hn::Zero(f)));
        const auto depth = clamp_w(f, at(tile.wx, tile.wy, tile.wc), least_w, greatest_w);
        hn::Store(hn::IfThenElseZero(inside, depth), f, tile.tiny_w[k] + i);
    }
}

/// Stores the texels of a tiny box.
HWY_INLINE void store_tiny(DepthTile& tile, int i)
{
    for (int k = 0; k < 4; ++k) {
        const int x = k & 1 ? tile.x1[i] : tile.x0[i], y = k & 2 ? tile.y1[i] : tile.y0[i];
        float& stored = tile.w[std::size_t(tile.column_offset[x] + tile.row_offset[y])];
        stored = std::max(stored, tile.tiny_w[k][i]);
    }
}

/// Rasterises triangle i over the registers of its box.
HWY_INLINE void raster_triangle(DepthTile& tile, int i)
{
    const Samples d;
    const LaneOffsets<Samples> lane(d);
    const auto set = [&](float v) { return hn::Set(d, v); };
    const auto gx0 = set(tile.gx[0][i]), gx1 = set(tile.gx[1][i]), gx2 = set(tile.gx[2][i]),
               wx = set(tile.wx[i]);
    const auto least_w = set(tile.least_w[i]), greatest_w = set(tile.greatest_w[i]);
    const int first_x = tile.x0[i] & -columns(d), first_y = tile.y0[i] & -rows(d);
    for (int y = first_y; y <= tile.y1[i]; y += rows(d)) {
        const auto py = hn::Add(set(float(y)), lane.y);
        const auto row = [&](float gy, float c) { return hn::Add(hn::Mul(set(gy), py), set(c)); };
        const auto r0 = row(tile.gy[0][i], tile.c[0][i]), r1 = row(tile.gy[1][i], tile.c[1][i]),
                   r2 = row(tile.gy[2][i], tile.c[2][i]), rw = row(tile.wy[i], tile.wc[i]);
        for (int x = first_x; x <= tile.x1[i]; x += columns(d)) {
            const auto px = hn::Add(set(float(x)), lane.x);
            const auto along = [&](auto g, auto r) { return hn::Add(hn::Mul(g, px), r); };
            const auto least = hn::Min(along(gx0, r0), hn::Min(along(gx1, r1), along(gx2, r2)));
            const auto inside = hn::Ge(least, hn::Zero(d));
            float* at = tile.w.data() + tile.column_offset[x] + tile.row_offset[y];
            const auto stored = hn::Load(d, at);
            const auto w = clamp_w(d, along(wx, rw), least_w, greatest_w);
            hn::Store(hn::IfThenElse(inside, hn::Max(w, stored), stored), d, at);
        }
    }
}

template <CornerSpace kSpace>
void raster_batch(DepthTile& tile, float x0, float y0)
{
    for (int i = 0; i < tile.count; i += int(hn::Lanes(Wide()))) {
        if constexpr (kSpace == CornerSpace::flat)
            set_up_flat(tile, i, x0, y0);
        else
            set_up_careful(tile, i, x0, y0);
    }
    for (int i = 0; i < tile.count; i += int(hn::Lanes(hn::CappedTag<float, 8>())))
        set_up_tiny(tile, i);
    // Split into two lists without branches, which would often be mispredicted.
    std::uint8_t tiny[DepthTile::kBatch], larger[DepthTile::kBatch];
    int tiny_count = 0, larger_count = 0;
    for (int i = 0; i < tile.count; ++i) {
        tiny[tiny_count] = larger[larger_count] = std::uint8_t(i);
        tiny_count += tile.tiny[i] != 0;
        larger_count += tile.tiny[i] == 0;
    }
    for (int k = 0; k < tiny_count; ++k) store_tiny(tile, tiny[k]);
    for (int k = 0; k < larger_count; ++k) raster_triangle(tile, larger[k]);
    tile.count = 0;
}

template <CornerSpace kSpace>
HWY_INLINE void gather(const EyeMesh& mesh, const TileEntry& entry, DepthTile& tile)
{
    const int i = tile.count++;
    const glm::uvec3 index = mesh.index[entry.triangle];
    for (int k = 0; k < 3; ++k) {
        const glm::vec3 p = kSpace == CornerSpace::flat ? glm::vec3(mesh.corner[index[k]])
                                                        : eye_corner(mesh, index[k]);
        tile.corner[3 * k][i] = p.x;
        tile.corner[3 * k + 1][i] = p.y;
        tile.corner[3 * k + 2][i] = p.z;
    }
    tile.x0[i] = entry.x0, tile.y0[i] = entry.y0, tile.x1[i] = entry.x1, tile.y1[i] = entry.y1;
}

/// The tile's least 1/t, which belongs to its farthest depth.
float least_of(const DepthTile& tile)
{
    const hn::CappedTag<float, 16> d;
    auto least = hn::Load(d, tile.w.data());
    for (std::size_t k = hn::Lanes(d); k < tile.w.size(); k += hn::Lanes(d))
        least = hn::Min(least, hn::Load(d, tile.w.data() + k));
    return hn::GetLane(hn::MinOfLanes(d, least));
}

/// Whether the entry's box covers half of the tile's width and height or more.
HWY_INLINE bool is_large(const TileEntry& entry, int half)
{
    return entry.x1 - entry.x0 >= half && entry.y1 - entry.y0 >= half;
}

/// Stores the fragments that are nearer than what is stored.
void merge(std::span<const DepthFragment> fragments, DepthTile& tile)
{
    float* HWY_RESTRICT w = tile.w.data();
    for (const DepthFragment& fragment : fragments) {
        float& stored = w[fragment.sample & 0xFFFF];
        stored = std::max(stored, fragment.w);
    }
}

void raster_depths(const EyeMesh& mesh, const LatticeTile& rays, const TileBin<DepthFragment>& bin,
    DepthTile& tile)
{
    const std::span<const TileEntry> entries = bin.entries;
    const float x0 = rays.x0, y0 = rays.y0;
    std::fill_n(tile.w.data(), tile.w.size(), 0.0f);
    merge(bin.fragments, tile);
    // Large triangles first. Triangles behind them, such as all below a roof, change no depth and
    // are skipped.
    const int half = tile.size / 2;
    bool any_large = false, any_behind = false;
    const auto raster = [&](const TileEntry& entry) {
        gather<CornerSpace::flat>(mesh, entry, tile);
        if (tile.count == DepthTile::kBatch) raster_batch<CornerSpace::flat>(tile, x0, y0);
    };
    const auto is_behind = [](const TileEntry& entry) { return !(entry.nearest_z > 0); };
    const bool any_cutouts = mesh.cutouts.any();
    const auto is_cutout = [&](const TileEntry& entry) {
        return any_cutouts && mesh.cutouts.has(entry.triangle);
    };
    for (const TileEntry& entry : entries) {
        if (is_cutout(entry)) continue;
        any_behind |= is_behind(entry);
        if (is_behind(entry) || !is_large(entry, half)) continue;
        any_large = true;
        raster(entry);
    }
    raster_batch<CornerSpace::flat>(tile, x0, y0);
    const float least = any_large ? least_of(tile) : 0.0f;

    constexpr std::size_t kIndices = 24, kCorners = 12; // entries ahead
    for (std::size_t n = 0; n < entries.size(); ++n) {
        if (n + kIndices < entries.size())
            hwy::Prefetch(&mesh.index[entries[n + kIndices].triangle]);
        const TileEntry& entry = entries[n];
        // 1 / nearest_z is the greatest w that the triangle can store.
        if (is_behind(entry) || 1.0f / entry.nearest_z <= least) continue;
        if (is_cutout(entry)) continue;
        if (any_large && is_large(entry, half)) continue;
        if (n + kCorners < entries.size()) {
            const glm::uvec3& index = mesh.index[entries[n + kCorners].triangle];
            for (int k = 0; k < 3; ++k) hwy::Prefetch(&mesh.corner[index[k]]);
        }
        raster(entry);
    }
    raster_batch<CornerSpace::flat>(tile, x0, y0);
    if (!any_behind) return;
    for (const TileEntry& entry : entries) {
        if (!is_behind(entry) || is_cutout(entry)) continue;
        gather<CornerSpace::eye>(mesh, entry, tile);
        if (tile.count == DepthTile::kBatch) raster_batch<CornerSpace::eye>(tile, x0, y0);
    }
    raster_batch<CornerSpace::eye>(tile, x0, y0);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(raster_depths);

void resize(DepthTile& tile, int size)
{
    tile.size = size;
    tile.w.resize(std::size_t(size) * std::size_t(size));
    for (int k = 0; k < size; ++k) {
        tile.column_offset[k] = tile_offset(k, 0, size);
        tile.row_offset[k] = tile_offset(0, k, size);
    }
}

void raster_depth(
    const EyeMesh& mesh, const LatticeTile& rays, const TileBin<DepthFragment>& bin, DepthTile& out)
{
    HWY_DYNAMIC_DISPATCH(raster_depths)(mesh, rays, bin, out);
}

} // namespace firsthit
#endif
