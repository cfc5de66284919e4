// sample_shadow_map.cpp - how much of a light reaches the hits of a tile, by its shadow maps.
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

/// A map as a tile looks at it.
struct MapView {
    RayTransform to; // (texel x, texel y, depth), see ShadowMap::matrix
    const float* depth = nullptr;
    const FarthestDepths* farthest = nullptr;
    int width = 0;
    int height = 0;
    bool parallel = false;
    int filter = 1;
    float bias = -1;
    float reach = 0;    // of slope_bias
    float rounding = 0; // added to it, and kRounding of the depth
};

constexpr float kRounding = 0x1p-20f;

/// Half as much again as a plane needs: neighbours of a triangle are not in its plane.
constexpr double kNeighbours = 1.5;

MapView map_view(
    const ShadowMaps& maps, const ShadowLight& light, const ShadowMap& map, const HitTile& hits)
{
    MapView view;
    view.to = ray_transform(hits.frame, map.matrix, map.origin, map.offset);
    view.depth = map.depth.data();
    view.farthest = &map.farthest;
    view.width = map.width();
    view.height = map.height();
    view.parallel = light.frame.parallel;
    view.filter = maps.filter;
    view.bias = float(maps.bias);
    view.reach = float(kNeighbours * 0.5 * maps.filter * map.source.fit.texel);
    const glm::dvec3 eye = glm::abs(glm::dvec3(hits.frame.eye) - map.origin);
    view.rounding = kRounding * float(eye.x + eye.y + eye.z);
    return view;
}

FIRSTHIT_PURE real clamped(real x, float most)
{
    return max(min(x, real(most)), real(0.0f)); // no number: most
}

FIRSTHIT_PURE integer whole(real x)
{
    return integer(hn::ConvertTo(IntegerTag(), x.lanes));
}

/// Where the quads' row of texel row y starts, plus the row in the quad; and the same for a column
/// (see quad_offset).
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

/// Points as a map sees them.
struct MapPoints {
    real column, row; // texels
    real depth, epsilon;
    truth has_ray; // a shadow ray
};

HWY_INLINE MapPoints map_points(
    const MapView& map, float x, float y, int first, real t, real receiver_slope)
{
    const real3 p = transform_hits(map.to, x, y, first, t);
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

/// The share of the texels around the points at depth t that show nothing before them.
HWY_INLINE real lit_share(
    const MapView& map, float x, float y, int first, real t, real receiver_slope)
{
    const MapPoints points = map_points(map, x, y, first, t, receiver_slope);
    const real column = points.column, row = points.row;
    const float last_column = float(map.width - 1), last_row = float(map.height - 1);
    const int quads_x = quads(map.width);
    const auto start_of = [&](real at_row) {
        return row_offset(whole(clamped(at_row, last_row)), quads_x);
    };
    const auto lit_at = [&](integer start, real at_column) {
        const integer at = start + column_offset(whole(clamped(at_column, last_column)));
        return mix(real(1.0f), real(0.0f),
            is_shadowed(gather(map.depth, at), points.depth, points.epsilon));
    };
    real lit(0.0f);
    if (map.filter == 1) {
        lit = lit_at(start_of(floor(row)), floor(column));
    } else {
        const real half(0.5f * float(map.filter - 1));
        const real first_column = floor(column - half), first_row = floor(row - half);
        for (int j = 0; j < map.filter; ++j) {
            const integer start = start_of(first_row + real(float(j)));
            for (int i = 0; i < map.filter; ++i)
                lit = lit + lit_at(start, first_column + real(float(i)));
        }
        lit = lit / real(float(map.filter * map.filter));
    }
    return mix(real(1.0f), lit, points.has_ray);
}

/// Calls body(block's x, block's y, first sample of a register in its block, its offset in the
/// tile, its depths) for the registers that have an item.
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
            if (any(t < infinity)) body(x, y, first, offset, t);
        }
    }
}

/// What is known before a map is looked at: points that are seen from behind are dark.
FIRSTHIT_PURE real facing_share(real share, real receiver_slope)
{
    return mix(real(0.0f), share, receiver_slope > real(0.0f));
}

/// The points of a block on a map of which one texel is looked at: which, and how near something has to
/// be there to shadow the point.
struct BlockTexels {
    int block = -1;
    alignas(64) std::int32_t at[kBlockSamples];
    alignas(64) float limit[kBlockSamples];
};

/// Finds the texels, and asks for their memory.
HWY_INLINE void find_texels(
    const MapView& map, const HitTile& hits, int block, const float* lit, BlockTexels& texels)
{
    const int blocks_x = hits.size / kBlock;
    const float x = float(block % blocks_x * kBlock), y = float(block / blocks_x * kBlock);
    const float last_column = float(map.width - 1), last_row = float(map.height - 1);
    const int quads_x = quads(map.width);
    texels.block = block;
    for (int first = 0; first < kBlockSamples; first += kLanes) {
        const int offset = block * kBlockSamples + first;
        const MapPoints points =
            map_points(map, x, y, first, load(hits.t + offset), load(lit + offset));
        const integer at = row_offset(whole(clamped(floor(points.row), last_row)), quads_x) +
                           column_offset(whole(clamped(floor(points.column), last_column)));
        hn::Store(at.lanes, IntegerTag(), texels.at + first);
        store(mix(real(-std::numeric_limits<float>::infinity()), points.depth - points.epsilon,
                  points.has_ray),
            texels.limit + first);
    }
    // The corners of each quad of samples: what is between them is mostly in the same lines.
    for (int quad = 0; quad < kBlockSamples; quad += 16)
        for (const int corner : {0, 3, 12, 15}) hwy::Prefetch(map.depth + texels.at[quad + corner]);
}

/// The comparisons of is_shadowed. `lit` holds receiver_slope, and is left with light.
HWY_INLINE void compare_texels(const MapView& map, const BlockTexels& texels, float* lit)
{
    if (texels.block < 0) return;
    float* block = lit + texels.block * kBlockSamples;
    for (int first = 0; first < kBlockSamples; first += kLanes) {
        const real receiver_slope = load(block + first);
        const integer at(hn::Load(IntegerTag(), texels.at + first));
        const truth dark = gather(map.depth, at) < load(texels.limit + first);
        store(facing_share(mix(real(1.0f), real(0.0f), dark), receiver_slope), block + first);
    }
}

/// Whether the light sees a block's triangles from behind. Then it is left dark.
HWY_INLINE bool all_turned_away(float* receiver_slope)
{
    real steepest = load(receiver_slope);
    for (int first = kLanes; first < kBlockSamples; first += kLanes)
        steepest = max(steepest, load(receiver_slope + first));
    if (any(steepest > real(0.0f))) return false;
    std::fill_n(receiver_slope, kBlockSamples, 0.0f);
    return true;
}

/// sample_map_of_face with one texel a point: while the memory of a block's texels is on its way, those of the
/// block before are compared.
void fetch_texels(const MapView& face, const HitTile& hits, float* lit)
{
    BlockTexels texels[2];
    int now = 0;
    for (int block = 0; block < int(hits.blocks()); ++block) {
        if (hits.is_empty(block) || all_turned_away(lit + block * kBlockSamples)) continue;
        find_texels(face, hits, block, lit, texels[now]);
        now ^= 1;
        compare_texels(face, texels[now], lit);
    }
    compare_texels(face, texels[now ^ 1], lit);
}

/// All points are on one face. Every register holds its receiver_slope in `lit` and leaves its light
/// there.
void sample_map_of_face(const MapView& face, const HitTile& hits, float* lit)
{
    for_registers(hits, [&](float x, float y, int first, int offset, real t) {
        const real receiver_slope = load(lit + offset);
        real share(0.0f);
        if (any(receiver_slope > share))
            share = facing_share(lit_share(face, x, y, first, t, receiver_slope), receiver_slope);
        store(share, lit + offset);
    });
}

/// Whether all hits of the tile, which are on one face, are in shadow. `lit` holds their receiver_slope.
bool is_dark(const MapView& map, const HitTile& hits, const HitDepths& depths, const float* lit)
{
    const HitHull hull = hit_hull(map.to, 0, 0, hits.size, depths);
    const MapDepths under = depths_under(
        hull, map.parallel, *map.farthest, map.width, map.height, 0.5f * float(map.filter) + 1.5f);
    // The hits' own depths are rounded otherwise than the hull's; both are within epsilon's part for
    // rounding.
    const float before =
        under.hits.least -
        4 * (std::max(under.hits.greatest, -under.hits.least) * kRounding + map.rounding);
    if (!(under.farthest < before)) return false;
    if (map.bias >= 0) return under.farthest < before - map.bias;
    real steepest(0.0f);
    for_registers(hits, [&](float, float, int, int offset, real t) {
        const truth hit = t < real(std::numeric_limits<float>::infinity());
        steepest = max(steepest, mix(real(0.0f), load(lit + offset), hit));
    });
    const float at = map.parallel ? 1.0f : under.hits.greatest; // slope_bias, of the steepest
    const float epsilon =
        at * at * (hn::GetLane(hn::MaxOfLanes(RealTag(), steepest.lanes)) * map.reach);
    return under.farthest < before - 1.0001f * epsilon;
}

/// The same, each point on its own face.
void sample_maps_of_faces(
    const LightFrame& frame, const MapView (&face)[kFaces], const HitTile& hits, float* lit)
{
    const RayTransform to = ray_transform(hits.frame, frame.axes, frame.origin, glm::dvec3(0));
    for_registers(hits, [&](float x, float y, int first, int offset, real t) {
        const real receiver_slope = load(lit + offset);
        const OnFaces on = on_faces(transform_hits(to, x, y, first, t));
        const truth hit = t < real(std::numeric_limits<float>::infinity());
        real share(1.0f);
        for (int k = 0; k < kFaces; ++k) {
            const truth here = hit & on.of(k);
            if (face[k].width > 0 && any(here))
                share = mix(share, lit_share(face[k], x, y, first, t, receiver_slope), here);
        }
        store(facing_share(share, receiver_slope), lit + offset);
    });
}

/// The face that all hits of the tile are on, or -1 where they may be on several: the hull of its
/// corner rays between the least and the greatest depth is on a face if its corners are.
int common_face(const LightFrame& frame, const HitTile& hits, const HitDepths& depths)
{
    const double depth[2] = {double(depths.nearest), double(depths.farthest)};
    const RayTransform to = ray_transform(hits.frame, frame.axes, frame.origin, glm::dvec3(0));
    int common = -1;
    for (int corner = 0; corner < 8; ++corner) {
        const double x = corner & 1 ? hits.size - 1 : 0, y = corner & 2 ? hits.size - 1 : 0;
        const glm::dvec3 p = glm::dvec3(to.eye) + depth[corner / 4] * (x * glm::dvec3(to.right) +
                                                                          y * glm::dvec3(to.down) +
                                                                          glm::dvec3(to.forward));
        const glm::dvec3 size = glm::abs(p);
        const int axis = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
        const int face = 2 * axis + (p[axis] < 0 ? 1 : 0);
        if (corner > 0 && face != common) return -1;
        common = face;
    }
    return common;
}

/// Points outside of a spot's cone are dark.
void darken_outside(const LightFrame& frame, const HitTile& hits, float* lit)
{
    const RayTransform to = ray_transform(hits.frame, frame.axes, frame.origin, glm::dvec3(0));
    const float tan2_cone = float(frame.tan2_cone);
    for_registers(hits, [&](float x, float y, int first, int offset, real t) {
        const truth inside = in_cone(transform_hits(to, x, y, first, t), tan2_cone);
        store(mix(real(0.0f), load(lit + offset), inside), lit + offset);
    });
}

void sample_maps_of_tile(const ShadowMaps& maps, const ShadowLight& light, const World& world,
    const HitTile& hits, float* lit)
{
    const int samples = hits.size * hits.size;
    const HitDepths depths = tile_depths(hits);
    if (depths.hits == 0) return;
    spread_receiver_slope(hits, world, light.frame, lit);
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
        sample_maps_of_faces(light.frame, face, hits, lit);
    else if (is_dark(face[only], hits, depths, lit))
        std::fill_n(lit, samples, 0.0f);
    else if (maps.filter == 1)
        fetch_texels(face[only], hits, lit);
    else
        sample_map_of_face(face[only], hits, lit);
    if (light.frame.tan2_cone > 0) darken_outside(light.frame, hits, lit);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(sample_maps_of_tile);

void sample_shadow_map(
    const ShadowMaps& maps, const World& world, const HitTile& hits, std::size_t light, float* lit)
{
    HWY_DYNAMIC_DISPATCH(sample_maps_of_tile)(maps, maps.light[light], world, hits, lit);
}

} // namespace firsthit
#endif
