// sample_shadow_map.cpp - shadow map sampling: the visibility of a light from the hits of a tile.
//
// The array `visibility` has two uses here. First it holds the receiver slope of each sample
// (receiver_slope-inl.h); then each sample's slope is replaced by its visibility.
#include "shadow/map/sample_shadow_map.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <hwy/cache_control.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow/map/sample_shadow_map.cpp"
#include "base/simd.h"

#include "shadow/map/dark_tile-inl.h"
#include "shadow/map/receiver_slope-inl.h"

#include <algorithm>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

#include "glsl/shadow_map.glsl"

/// A map, and what sampling it for one tile needs.
struct MapView {
    Rays to; // from samples to (texel x, texel y, depth); see ShadowMap::matrix
    const float* depth = nullptr;
    const FarthestDepths* farthest = nullptr;
    int width = 0;
    int height = 0;
    bool parallel = false;
    int filter = 1;
    float bias = -1;
    float reach = 0;    // parameter of slope_bias
    float rounding = 0; // added to the slope bias, together with kRounding * depth
};

constexpr float kRounding = 0x1p-20f;

/// The slope bias is exact for a plane. The texels around a hit may show neighbouring triangles,
/// which are not in its plane, so half as much again is allowed.
constexpr double kNeighbours = 1.5;

MapView map_view(
    const ShadowMaps& maps, const ShadowLight& light, const ShadowMap& map, const HitTile& hits)
{
    MapView view;
    view.to = transformed(hits.rays, map.matrix, map.origin, map.offset);
    view.depth = map.depth.data();
    view.farthest = &map.farthest;
    view.width = map.width();
    view.height = map.height();
    view.parallel = light.frame.parallel;
    view.filter = maps.filter;
    view.bias = float(maps.bias);
    view.reach = float(kNeighbours * 0.5 * maps.filter * map.source.fit.texel);
    const glm::dvec3 eye = glm::abs(glm::dvec3(hits.rays.eye) - map.origin);
    view.rounding = kRounding * float(eye.x + eye.y + eye.z);
    if (hits.rays.parallel) {
        // Where a ray starts is rounded as the eye of others is.
        const glm::dvec2 reach = hits.rays.lattice().reach(hits.size, hits.size);
        const glm::dvec3 across = hits.rays.point_size(reach.x, reach.y, 0);
        view.rounding += kRounding * float(across.x + across.y + across.z);
    }
    return view;
}

FIRSTHIT_PURE real clamped(real x, float most)
{
    return max(min(x, real(most)), real(0.0f)); // NaN gives `most`
}

FIRSTHIT_PURE integer whole(real x)
{
    return integer(hn::ConvertTo(IntegerTag(), x.lanes));
}

/// quad_offset(column, row) is row_offset(row) + column_offset(column).
FIRSTHIT_PURE integer row_offset(integer y, int quads_x)
{
    const integer quads = integer(hn::ShiftRight<2>(y.lanes)) * integer(quads_x);
    return integer(hn::ShiftLeft<4>(quads.lanes)) +
           integer(hn::ShiftLeft<2>((y & integer(3)).lanes));
}
FIRSTHIT_PURE integer column_offset(integer x)
{
    return integer(hn::ShiftLeft<4>(hn::ShiftRight<2>(x.lanes))) + (x & integer(3));
}

/// A register of hits in the space of a map.
struct MapPoints {
    real column, row; // texels
    real depth, epsilon;
    truth has_ray; // there is a shadow ray; else the point is lit
};

/// A register of hits of a block.
struct HitRegister {
    float x, y; // the first sample of the block, in the tile
    int first;  // the first sample of the register, in the block
    real t;     // depths
};

HWY_INLINE real3 transform_hits(const Rays& to, const HitRegister& hits)
{
    return transform_hits(to, hits.x, hits.y, hits.first, hits.t);
}

HWY_INLINE MapPoints map_points(const MapView& map, const HitRegister& hits, real receiver_slope)
{
    const real3 p = transform_hits(map.to, hits);
    MapPoints points{p.x, p.y, p.z, real(map.bias), abs(p.z) < real(1e30f)};
    if (!map.parallel) {
        const real inv_depth = real(1.0f) / p.z;
        points.column = p.x * inv_depth;
        points.row = p.y * inv_depth;
        points.has_ray = points.has_ray & (p.z > real(0.0f));
    }
    if (map.bias < 0)
        points.epsilon =
            slope_bias(map.parallel ? real(1.0f) : p.z, receiver_slope, real(map.reach)) +
            (p.z * real(kRounding) + real(map.rounding));
    return points;
}

/// The fraction of the texels around the hits that show no triangle in front of them.
HWY_INLINE real visible_fraction(const MapView& map, const HitRegister& hits, real receiver_slope)
{
    const MapPoints points = map_points(map, hits, receiver_slope);
    const real column = points.column, row = points.row;
    const float last_column = float(map.width - 1), last_row = float(map.height - 1);
    const int quads_x = quads(map.width);
    const auto start_of = [&](real at_row) {
        return row_offset(whole(clamped(at_row, last_row)), quads_x);
    };
    const auto visibility_at = [&](integer start, real at_column) {
        const integer at = start + column_offset(whole(clamped(at_column, last_column)));
        return mix(real(1.0f), real(0.0f),
            is_shadowed_by_texel(gather(map.depth, at), points.depth, points.epsilon));
    };
    real visibility(0.0f);
    if (map.filter == 1) {
        visibility = visibility_at(start_of(floor(row)), floor(column));
    } else {
        const real half(0.5f * float(map.filter - 1));
        const real first_column = floor(column - half), first_row = floor(row - half);
        for (int j = 0; j < map.filter; ++j) {
            const integer start = start_of(first_row + real(float(j)));
            for (int i = 0; i < map.filter; ++i)
                visibility = visibility + visibility_at(start, first_column + real(float(i)));
        }
        visibility = visibility / real(float(map.filter * map.filter));
    }
    return mix(real(1.0f), visibility, points.has_ray);
}

/// Calls body(HitRegister, offset) for each register that has an item. `offset` is the number of the
/// register's first sample in the tile.
template <class Body>
HWY_INLINE void for_registers(const HitTile& hits, const Body& body)
{
    const real infinity(std::numeric_limits<float>::infinity());
    const int blocks_x = hits.size / kBlock;
    for (int block = 0; block < blocks_x * blocks_x; ++block) {
        if (hits.is_empty(block)) continue;
        const float x = float(block % blocks_x * kBlock), y = float(block / blocks_x * kBlock);
        for (int first = 0; first < kBlockSamples; first += kLanes) {
            const int offset = block * kBlockSamples + first;
            const real t = load(hits.t + offset);
            if (any(t < infinity)) body(HitRegister{x, y, first, t}, offset);
        }
    }
}

/// 0 where the receiver does not face the light (receiver_slope <= 0), else `visibility`.
FIRSTHIT_PURE real facing_visibility(real visibility, real receiver_slope)
{
    return mix(real(0.0f), visibility, receiver_slope > real(0.0f));
}

/// For the points of a block and a map that is sampled without a filter: the texel of each point,
/// and the depth below which that texel shadows the point.
struct BlockTexels {
    int block = -1;
    alignas(64) std::int32_t at[kBlockSamples]; // offset in the map, see quad_offset
    alignas(64) float limit[kBlockSamples];
};

/// Finds the texels of a block and prefetches them.
HWY_INLINE void find_texels(const MapView& map, const HitTile& hits, int block,
    const float* visibility, BlockTexels& texels)
{
    const int blocks_x = hits.size / kBlock;
    const float x = float(block % blocks_x * kBlock), y = float(block / blocks_x * kBlock);
    const float last_column = float(map.width - 1), last_row = float(map.height - 1);
    const int quads_x = quads(map.width);
    texels.block = block;
    for (int first = 0; first < kBlockSamples; first += kLanes) {
        const int offset = block * kBlockSamples + first;
        const MapPoints points =
            map_points(map, {x, y, first, load(hits.t + offset)}, load(visibility + offset));
        const integer at = row_offset(whole(clamped(floor(points.row), last_row)), quads_x) +
                           column_offset(whole(clamped(floor(points.column), last_column)));
        hn::Store(at.lanes, IntegerTag(), texels.at + first);
        store(mix(real(-std::numeric_limits<float>::infinity()), points.depth - points.epsilon,
                  points.has_ray),
            texels.limit + first);
    }
    // Prefetch for the corners of each 4x4 quad only: the other texels are mostly in the same cache
    // lines.
    for (int quad = 0; quad < kBlockSamples; quad += 16)
        for (const int corner : {0, 3, 12, 15}) hwy::Prefetch(map.depth + texels.at[quad + corner]);
}

/// Compares the block's points with their texels, as is_shadowed_by_texel does, and replaces the
/// receiver slopes in `visibility` by visibility.
HWY_INLINE void compare_texels(const MapView& map, const BlockTexels& texels, float* visibility)
{
    if (texels.block < 0) return;
    float* block = visibility + texels.block * kBlockSamples;
    for (int first = 0; first < kBlockSamples; first += kLanes) {
        const real receiver_slope = load(block + first);
        const integer at(hn::Load(IntegerTag(), texels.at + first));
        const truth dark = gather(map.depth, at) < load(texels.limit + first);
        store(facing_visibility(mix(real(1.0f), real(0.0f), dark), receiver_slope), block + first);
    }
}

/// Whether no triangle of a block faces the light. Then the block's visibility is set to 0.
HWY_INLINE bool all_turned_away(float* receiver_slope)
{
    real steepest = load(receiver_slope);
    for (int first = kLanes; first < kBlockSamples; first += kLanes)
        steepest = max(steepest, load(receiver_slope + first));
    if (any(steepest > real(0.0f))) return false;
    std::fill_n(receiver_slope, kBlockSamples, 0.0f);
    return true;
}

/// sample_map_of_face without a filter. Software pipelined: prefetches the texels of a block, then
/// compares those of the block before, which have arrived meanwhile.
void sample_map_pipelined(const MapView& face, const HitTile& hits, float* visibility)
{
    BlockTexels texels[2];
    int now = 0;
    for (int block = 0; block < int(hits.blocks()); ++block) {
        if (hits.is_empty(block) || all_turned_away(visibility + block * kBlockSamples)) continue;
        find_texels(face, hits, block, visibility, texels[now]);
        now ^= 1;
        compare_texels(face, texels[now], visibility);
    }
    compare_texels(face, texels[now ^ 1], visibility);
}

/// Samples the map of the only face that the tile's hits lie on.
void sample_map_of_face(const MapView& face, const HitTile& hits, float* visibility)
{
    for_registers(hits, [&](const HitRegister& some, int offset) {
        const real receiver_slope = load(visibility + offset);
        real visible(0.0f);
        if (any(receiver_slope > visible))
            visible =
                facing_visibility(visible_fraction(face, some, receiver_slope), receiver_slope);
        store(visible, visibility + offset);
    });
}

/// Whether all hits of the tile, which lie on one face, are in shadow (dark_tile-inl.h).
/// `visibility` holds their receiver slopes.
bool is_dark(
    const MapView& map, const HitTile& hits, const HitDepths& depths, const float* visibility)
{
    const HitHull hull = hit_hull(map.to, 0, 0, hits.size, depths);
    const MapDepths under = depths_under(hull, {*map.farthest, map.width, map.height, map.parallel},
        0.5f * float(map.filter) + 1.5f);
    // The depths of the hits are rounded differently from those of the hull. Both errors are within
    // the rounding term of epsilon.
    const float before =
        under.hits.least -
        4 * (std::max(under.hits.greatest, -under.hits.least) * kRounding + map.rounding);
    if (!(under.farthest < before)) return false;
    if (map.bias >= 0) return under.farthest < before - map.bias;
    real steepest(0.0f);
    for_registers(hits, [&](const HitRegister& some, int offset) {
        const truth hit = some.t < real(std::numeric_limits<float>::infinity());
        steepest = max(steepest, mix(real(0.0f), load(visibility + offset), hit));
    });
    const float at = map.parallel ? 1.0f : under.hits.greatest; // slope_bias of the greatest slope
    const float epsilon =
        at * at * (hn::GetLane(hn::MaxOfLanes(RealTag(), steepest.lanes)) * map.reach);
    return under.farthest < before - 1.0001f * epsilon;
}

/// Samples the maps of all faces, each point in the map of its own face.
void sample_maps_of_faces(
    const LightFrame& frame, const MapView (&face)[kFaces], const HitTile& hits, float* visibility)
{
    const Rays to = transformed(hits.rays, frame.axes, frame.origin, glm::dvec3(0));
    for_registers(hits, [&](const HitRegister& some, int offset) {
        const real receiver_slope = load(visibility + offset);
        const OnFaces on = on_faces(transform_hits(to, some));
        const truth hit = some.t < real(std::numeric_limits<float>::infinity());
        real visible(1.0f);
        for (int k = 0; k < kFaces; ++k) {
            const truth here = hit & on.of(k);
            if (face[k].width > 0 && any(here))
                visible = mix(visible, visible_fraction(face[k], some, receiver_slope), here);
        }
        store(facing_visibility(visible, receiver_slope), visibility + offset);
    });
}

/// The face that all hits of the tile certainly lie on, or -1. A face's pyramid is convex, so the
/// tile's convex hull (see hit_hull-inl.h) lies on a face if its corners do. Corners that are
/// within a hit's rounding of two faces count as lying on none, so that every hit is sampled on the
/// face that sample_maps_of_faces would choose.
int common_face(const LightFrame& frame, const HitTile& hits, const HitDepths& depths)
{
    const double depth[2] = {double(depths.nearest), double(depths.farthest)};
    const Rays to = transformed(hits.rays, frame.axes, frame.origin, glm::dvec3(0));
    int common = -1;
    for (int corner = 0; corner < 8; ++corner) {
        const double x = double(to.x0) + (corner & 1 ? hits.size - 1 : 0),
                     y = double(to.y0) + (corner & 2 ? hits.size - 1 : 0);
        const double t = depth[corner / 4];
        const glm::dvec3 p = to.point(x, y, t), size = glm::abs(p);
        const glm::dvec3 added = to.point_size(x, y, t);
        const double rounding = double(kRounding) * std::max({added.x, added.y, added.z});
        const int axis = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
        if (!(size[axis] - std::max(size[(axis + 1) % 3], size[(axis + 2) % 3]) > rounding))
            return -1;
        const int face = 2 * axis + (p[axis] < 0 ? 1 : 0);
        if (corner > 0 && face != common) return -1;
        common = face;
    }
    return common;
}

/// Sets the visibility of points outside a spot light's cone to 0.
void clear_outside_cone(const LightFrame& frame, const HitTile& hits, float* visibility)
{
    const Rays to = transformed(hits.rays, frame.axes, frame.origin, glm::dvec3(0));
    const float tan2_cone = float(frame.tan2_cone);
    for_registers(hits, [&](const HitRegister& some, int offset) {
        const truth inside = in_cone(transform_hits(to, some), tan2_cone);
        store(mix(real(0.0f), load(visibility + offset), inside), visibility + offset);
    });
}

void sample_maps_of_tile(const ShadowMaps& maps, const ShadowLight& light, const World& world,
    const HitTile& hits, float* visibility)
{
    const int samples = hits.size * hits.size;
    const HitDepths depths = tile_depths(hits);
    if (depths.hits == 0) return;
    spread_receiver_slope(hits, world, light.frame, visibility);
    MapView face[kFaces];
    int faces = 0, only = -1;
    for (int k = 0; k < kFaces; ++k) {
        if (light.map[std::size_t(k)].width() == 0) continue;
        face[k] = map_view(maps, light, light.map[std::size_t(k)], hits);
        ++faces;
        only = k;
    }
    if (faces > 1) only = common_face(light.frame, hits, depths);
    if (only < 0 || face[only].width == 0)
        sample_maps_of_faces(light.frame, face, hits, visibility);
    else if (is_dark(face[only], hits, depths, visibility))
        std::fill_n(visibility, samples, 0.0f);
    else if (maps.filter == 1)
        sample_map_pipelined(face[only], hits, visibility);
    else
        sample_map_of_face(face[only], hits, visibility);
    if (light.frame.tan2_cone > 0) clear_outside_cone(light.frame, hits, visibility);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(sample_maps_of_tile);

void sample_shadow_map(const ShadowMaps& maps, const World& world, const HitTile& hits,
    std::size_t light, float* visibility)
{
    HWY_DYNAMIC_DISPATCH(sample_maps_of_tile)(maps, maps.light[light], world, hits, visibility);
}

} // namespace firsthit
#endif
