// tile_occlusion.cpp - occluder culling: finds tiles that one large occluder hides from a light.
#include "shadow/exact/tile_occlusion.h"

#include "irregular/mesh/face_occluders.h"
#include "irregular/cells/shadowed_box.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace firsthit {
namespace {

using glm::dvec3;

constexpr std::uint32_t kFewTriangles = 12;  // of a scene instance; a box has 12
constexpr std::size_t kMostOccluders = 8192; // each costs about 40 ns for every light

/// Lists the triangles of all scene instances with at most kFewTriangles triangles, none of them
/// cut-outs; if these are more than kMostOccluders, lowers the limit for a scene instance until they
/// are not.
void find_occluders(const Scene& scene, const Cutouts& cutouts, Buffer<std::uint32_t>& occluders)
{
    const auto is_cutout = [&](const Instance& instance) {
        return instance.triangle_count > 0 && cutouts.has(instance.first_triangle);
    };
    std::array<std::size_t, kFewTriangles + 1>
        triangles{}; // in scene instances of k triangles, by k
    for (const Instance& instance : scene.instances)
        if (instance.triangle_count <= kFewTriangles && !is_cutout(instance))
            triangles[instance.triangle_count] += instance.triangle_count;
    std::uint32_t few = 0;
    std::size_t count = 0;
    while (few < kFewTriangles && count + triangles[few + 1] <= kMostOccluders)
        count += triangles[++few];
    occluders.resize(count);
    std::size_t next = 0;
    for (const Instance& instance : scene.instances)
        if (instance.triangle_count <= few && !is_cutout(instance))
            for (std::uint32_t k = 0; k < instance.triangle_count; ++k)
                occluders[next++] = instance.first_triangle + k;
}

dvec3 in_light_space(const PencilSpace& space, const dvec3& p)
{
    return space.directional ? space.turned(p) : p - dvec3(space.origin);
}

Corners corners_in_light_space(const World& world, const PencilSpace& space, std::uint32_t triangle)
{
    const glm::uvec3& c = world.scene->index[triangle];
    const auto& at = world.position;
    return {to_light(space, at[c.x]), to_light(space, at[c.y]), to_light(space, at[c.z])};
}

/// How far outside its tile's hull each coordinate of a lifted hit may lie, in the light's space.
double slack_of(const TileHull& hull, const PencilSpace& space, double farthest)
{
    const double light = double(largest_coordinate(space.origin)) + double(space.reach);
    const double corner = 2 * (farthest + light); // bounds any corner in the light's space
    constexpr double kUnderflow = 0x1p-140;       // absolute rounding error of floats near zero
    return 2 * hull.rounding + kPositionRounding * light + double(kShadowMargin) * corner +
           kUnderflow;
}

/// The bounds on a face of boxes of half side `slack` around the points; nothing if the face does
/// not see all of them.
std::optional<SampleBounds> project_bounds(
    const CubeFace& face, const std::array<dvec3, 8>& points, double slack)
{
    SampleBounds bounds;
    for (const dvec3& p : points) {
        // A point beyond kFarthest has no shadow ray, so it is never in shadow.
        if (!(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) + slack < kFarthest))
            return {};
        const double a = p[face.axis_a], b = p[face.axis_b], c = double(face.sign) * p[face.axis_c];
        if (face.directional) {
            bounds.add({float(a - slack), float(b - slack), float(a + slack), float(b + slack),
                float(-c - slack), float(-c + slack)});
            continue;
        }
        const double near = c - slack, far = c + slack;
        if (!(near > 0)) return {};
        const auto low = [&](double v) {
            return float(v - slack < 0 ? (v - slack) / near : (v - slack) / far);
        };
        const auto high = [&](double v) {
            return float(v + slack > 0 ? (v + slack) / near : (v + slack) / far);
        };
        bounds.add({low(a), low(b), high(a), high(b), float(1 / far), float(1 / near)});
    }
    const float widest = std::max({-bounds.x0, -bounds.y0, bounds.x1, bounds.y1});
    if (!face.directional && !(widest <= kWideFaceLimit)) return {};
    return bounds;
}

/// Projects every tile's hull onto a face of the light: onto one common face if a single face sees
/// all tiles, else each onto the face whose axis it is nearest to.
void project_tiles(const PencilSpace& space, TileOcclusion& tile_occlusion, Tasks& tasks)
{
    const auto box_of = [&](const TileHull& hull) {
        VertexBox box;
        for (const dvec3& p : hull.corner) {
            const glm::vec3 seen(in_light_space(space, p));
            box.add({seen, seen});
        }
        return box;
    };
    VertexBox all;
    for (const TileHull& hull : tile_occlusion.hulls.span())
        if (!hull.empty) all.add(box_of(hull));
    const int common = space.directional ? 0 : find_wide_face(all);
    tile_occlusion.bounds.resize(tile_occlusion.hulls.size());
    tasks.for_each(tile_occlusion.hulls.size(), [&](std::size_t tile, std::size_t) {
        const TileHull& hull = tile_occlusion.hulls[tile];
        TileBounds& projected = tile_occlusion.bounds[tile] = {};
        if (hull.empty) return;
        const int number = common >= 0 ? common : find_wide_face(box_of(hull));
        if (number < 0) return;
        std::array<dvec3, 8> points;
        for (std::size_t k = 0; k < 8; ++k) points[k] = in_light_space(space, hull.corner[k]);
        const auto bounds = project_bounds(cube_face(space.directional, number), points,
            slack_of(hull, space, tile_occlusion.farthest));
        if (bounds) projected = {number, *bounds};
    });
}

/// The approximate bounding box of a triangle on a face; false if the face does not see it.
bool project_triangle_to_face(const CubeFace& face, const Corners& corners, ProjectedTriangle& box)
{
    if (!usable(corners)) return false;
    if (face.directional) {
        const glm::vec3 low = glm::min(glm::min(corners[0], corners[1]), corners[2]),
                        high = glm::max(glm::max(corners[0], corners[1]), corners[2]);
        box = {box.triangle, low.x, low.y, high.x, high.y, -low.z};
        return true;
    }
    SampleBounds bounds;
    for (const glm::vec3& corner : corners) {
        const glm::vec3 p = face.to_face_axes(corner);
        if (!(p.z > 0)) return project_clipped(face, corners, box);
        const float w = 1 / p.z, x = p.x * w, y = p.y * w;
        bounds.add({x, y, x, y, w, w});
    }
    box = {box.triangle, bounds.x0, bounds.y0, bounds.x1, bounds.y1, bounds.nearest_w};
    return true;
}

/// Chooses the triangles that cover the largest areas of the bounds on a face.
FaceOccluders occluders_of(const World& world, const PencilSpace& space, const CubeFace& face,
    const SampleBounds& bounds, std::span<const std::uint32_t> occluders)
{
    FaceOccluderChoice choice(bounds);
    for (const std::uint32_t triangle : occluders) {
        ProjectedTriangle box{triangle, 0, 0, 0, 0, 0};
        if (project_triangle_to_face(face, corners_in_light_space(world, space, triangle), box))
            choice.offer(box);
    }
    return choice.occluders;
}

/// The occluders of one face of a light.
struct Occluders {
    const World& world;
    const PencilSpace& space;
    const Cutouts& cutouts;
    CubeFace face;
    FaceOccluders occluders;

    /// Whether one occluder (a triangle, or a pair of triangles with consecutive ids) certainly
    /// shadows all hits of the tile.
    bool hide(const SampleBounds& bounds, const HitTile& hits) const
    {
        for (const ProjectedTriangle& seen : occluders.span()) {
            if (!(seen.x0 <= bounds.x1 && seen.x1 >= bounds.x0 && seen.y0 <= bounds.y1 &&
                    seen.y1 >= bounds.y0 && seen.nearest_w > bounds.nearest_w))
                continue;
            const std::uint32_t first = seen.triangle;
            const Corners corners = corners_in_light_space(world, space, first);
            if (shadows_box(space, face, corners, bounds) && nothing_is_on(first, first, hits))
                return true;
            if (hide_with(first, corners, first + 1, bounds, hits) ||
                hide_with(first, corners, first - 1, bounds, hits))
                return true;
        }
        return false;
    }

  private:
    /// Tests a triangle together with one of a consecutive id, which in a quad or a fan is its
    /// neighbour; it need not be.
    bool hide_with(std::uint32_t first, const Corners& corners, std::uint32_t second,
        const SampleBounds& bounds, const HitTile& hits) const
    {
        if (second >= world.scene->index.size() || cutouts.has(second)) return false;
        const Corners others = corners_in_light_space(world, space, second);
        return usable(others) && pair_shadows_box(space, face, corners, others, bounds) &&
               nothing_is_on(first, second, hits);
    }

    static bool nothing_is_on(std::uint32_t first, std::uint32_t second, const HitTile& hits)
    {
        return std::none_of(hits.runs.begin(), hits.runs.end(),
            [&](const HitRun& run) { return run.item == first || run.item == second; });
    }
};

} // namespace

void start_tile_occlusion(
    const World& world, std::size_t tiles, TileOcclusion& tile_occlusion, Tasks& tasks)
{
    tile_occlusion.cutouts.find(*world.scene, kShadowOpacity);
    find_occluders(*world.scene, tile_occlusion.cutouts, tile_occlusion.occluders);
    if (!tile_occlusion.has_occluders()) return;
    tile_occlusion.hulls.resize(tiles);
    constexpr std::size_t kRange = 8192; // vertices
    tile_occlusion.range_farthest.resize((world.position.size() + kRange - 1) / kRange);
    tasks.for_ranges(world.position.size(), kRange, [&](std::size_t first, std::size_t last) {
        tile_occlusion.range_farthest[first / kRange] =
            largest_coordinate(std::span(world.position).subspan(first, last - first));
    });
    tile_occlusion.farthest = 0;
    for (const float farthest : tile_occlusion.range_farthest.span())
        tile_occlusion.farthest = std::max(tile_occlusion.farthest, double(farthest));
}

void add_hits(const HitTile& hits, std::size_t tile, TileOcclusion& tile_occlusion)
{
    tile_occlusion.hulls[tile] = tile_hull(hits);
}

bool find_occluded_tiles(const World& world, const PencilSpace& space,
    std::span<const HitTile> tiles, TileOcclusion& tile_occlusion, Tasks& tasks)
{
    project_tiles(space, tile_occlusion, tasks);
    const auto on_face = [&](int face) {
        return Occluders{
            world, space, tile_occlusion.cutouts, cube_face(space.directional, face), {}};
    };
    std::array faces{on_face(0), on_face(1), on_face(2), on_face(3), on_face(4), on_face(5)};
    for (int face = 0; face < kCubeFaces; ++face) {
        SampleBounds bounds;
        for (const TileBounds& tile : tile_occlusion.bounds.span())
            if (tile.face == face) bounds.add(tile.bounds);
        if (bounds.x0 <= bounds.x1)
            faces[std::size_t(face)].occluders = occluders_of(world, space,
                faces[std::size_t(face)].face, bounds, tile_occlusion.occluders.span());
    }
    tile_occlusion.hidden.resize(tiles.size());
    tasks.for_each(tiles.size(), [&](std::size_t tile, std::size_t) {
        const TileBounds& seen = tile_occlusion.bounds[tile];
        tile_occlusion.hidden[tile] =
            tile_occlusion.hulls[tile].empty ||
            (seen.face >= 0 && faces[std::size_t(seen.face)].hide(seen.bounds, tiles[tile]));
    });
    const auto hidden = tile_occlusion.hidden.span();
    return std::find(hidden.begin(), hidden.end(), 0) == hidden.end();
}

} // namespace firsthit
