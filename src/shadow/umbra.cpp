// umbra.cpp - tiles that a wall hides from a light as a whole.
#include "shadow/umbra.h"

#include "irregular/cover_choice.h"
#include "irregular/shadowed_box.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace firsthit {
namespace {

using glm::dvec3;

constexpr std::uint32_t kFewTriangles = 12; // of a part: a box
constexpr std::size_t kMostWalls = 8192;    // 40 ns each for every light

/// The triangles of parts that have few; where these would be too many, of parts with fewer.
void find_walls(const Scene& scene, Buffer<std::uint32_t>& walls)
{
    std::array<std::size_t, kFewTriangles + 1> triangles{}; // of all parts that have so many
    for (const Part& part : scene.parts)
        if (part.triangle_count <= kFewTriangles)
            triangles[part.triangle_count] += part.triangle_count;
    std::uint32_t few = 0;
    std::size_t count = 0;
    while (few < kFewTriangles && count + triangles[few + 1] <= kMostWalls)
        count += triangles[++few];
    walls.resize(count);
    std::size_t next = 0;
    for (const Part& part : scene.parts)
        if (part.triangle_count <= few)
            for (std::uint32_t k = 0; k < part.triangle_count; ++k)
                walls[next++] = part.first_triangle + k;
}

dvec3 in_light_space(const LightSpace& space, const dvec3& p)
{
    return space.directional ? space.axes * p : p - dvec3(space.origin);
}

Corners corners_in_light_space(const World& world, const LightSpace& space, std::uint32_t triangle)
{
    const glm::uvec3& c = world.scene->index[triangle];
    const auto& at = world.position;
    return {to_light(space, at[c.x]), to_light(space, at[c.y]), to_light(space, at[c.z])};
}

/// How far a hit, lifted off its triangle, may lie outside of its tile's hull, each coordinate.
double slack_of(const TileHull& hull, const LightSpace& space, double farthest)
{
    const double light = double(largest_coordinate(space.origin)) + double(space.reach);
    const double corner = 2 * (farthest + light); // of any triangle, in the light's space
    constexpr double kUnderflow = 0x1p-140;       // of floats near zero
    return 2 * hull.rounding + kPositionRounding * light + double(kShadowMargin) * corner +
           kUnderflow;
}

/// The bounds of points with some slack, as a face sees them; nothing where it does not see all.
std::optional<SampleBounds> seen_by(
    const LightFace& face, const std::array<dvec3, 8>& points, double slack)
{
    SampleBounds bounds;
    for (const dvec3& p : points) {
        // Farther out there might be points without a shadow ray.
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
    if (!face.directional && !(widest <= kWidestFace)) return {};
    return bounds;
}

/// One face for all tiles where there is one; else each has that where it is nearest to the middle.
void look_at_tiles(const LightSpace& space, Umbra& umbra, Tasks& tasks)
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
    for (const TileHull& hull : umbra.hulls.span())
        if (!hull.empty) all.add(box_of(hull));
    const int common = space.directional ? 0 : find_wide_face(all);
    umbra.sights.resize(umbra.hulls.size());
    tasks.for_each(umbra.hulls.size(), [&](std::size_t tile, std::size_t) {
        const TileHull& hull = umbra.hulls[tile];
        TileSight& sight = umbra.sights[tile] = {};
        if (hull.empty) return;
        const int number = common >= 0 ? common : find_wide_face(box_of(hull));
        if (number < 0) return;
        std::array<dvec3, 8> points;
        for (std::size_t k = 0; k < 8; ++k) points[k] = in_light_space(space, hull.corner[k]);
        const auto bounds = seen_by(
            light_face(space.directional, number), points, slack_of(hull, space, umbra.farthest));
        if (bounds) sight = {number, *bounds};
    });
}

/// The box of a triangle, about; false where the face does not see it.
bool see_triangle(const LightFace& face, const Corners& corners, SeenTriangle& box)
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
        const glm::vec3 p = face.seen_from(corner);
        if (!(p.z > 0)) return see_careful(face, corners, box);
        const float w = 1 / p.z, x = p.x * w, y = p.y * w;
        bounds.add({x, y, x, y, w, w});
    }
    box = {box.triangle, bounds.x0, bounds.y0, bounds.x1, bounds.y1, bounds.nearest_w};
    return true;
}

/// The triangles that cover most of what a face sees.
CoverList covers_of(const World& world, const LightSpace& space, const LightFace& face,
    const SampleBounds& bounds, std::span<const std::uint32_t> walls)
{
    CoverChoice choice(bounds);
    for (const std::uint32_t wall : walls) {
        SeenTriangle box{wall, 0, 0, 0, 0, 0};
        if (see_triangle(face, corners_in_light_space(world, space, wall), box)) choice.offer(box);
    }
    return choice.covers;
}

/// What one light's face sees of the walls, and asks of them.
struct Walls {
    const World& world;
    const LightSpace& space;
    LightFace face;
    CoverList covers;

    /// Whether one of the triangles certainly shadows all hits of the tile, or one and the next.
    bool hide(const SampleBounds& bounds, const HitTile& hits) const
    {
        for (const SeenTriangle& seen : covers.span()) {
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
    /// The other one may be the neighbour in a quad or a fan, or none.
    bool hide_with(std::uint32_t first, const Corners& corners, std::uint32_t second,
        const SampleBounds& bounds, const HitTile& hits) const
    {
        if (second >= world.scene->index.size()) return false;
        const Corners others = corners_in_light_space(world, space, second);
        return usable(others) && shadow_box(space, face, corners, others, bounds) &&
               nothing_is_on(first, second, hits);
    }

    static bool nothing_is_on(std::uint32_t first, std::uint32_t second, const HitTile& hits)
    {
        return std::none_of(hits.runs.begin(), hits.runs.end(),
            [&](const HitRun& run) { return run.item == first || run.item == second; });
    }
};

} // namespace

void start_umbra(const World& world, std::size_t tiles, Umbra& umbra, Tasks& tasks)
{
    find_walls(*world.scene, umbra.walls);
    if (!umbra.has_walls()) return;
    umbra.hulls.resize(tiles);
    constexpr std::size_t kRange = 8192; // vertices
    umbra.range_farthest.resize((world.position.size() + kRange - 1) / kRange);
    tasks.for_ranges(world.position.size(), kRange, [&](std::size_t first, std::size_t last) {
        umbra.range_farthest[first / kRange] =
            largest_coordinate(std::span(world.position).subspan(first, last - first));
    });
    umbra.farthest = 0;
    for (const float farthest : umbra.range_farthest.span())
        umbra.farthest = std::max(umbra.farthest, double(farthest));
}

void add_hits(const HitTile& hits, std::size_t tile, Umbra& umbra)
{
    umbra.hulls[tile] = tile_hull(hits);
}

bool find_umbra(const World& world, const LightSpace& space, std::span<const HitTile> tiles,
    Umbra& umbra, Tasks& tasks)
{
    look_at_tiles(space, umbra, tasks);
    const auto walls_of = [&](int face) {
        return Walls{world, space, light_face(space.directional, face), {}};
    };
    std::array walls{walls_of(0), walls_of(1), walls_of(2), walls_of(3), walls_of(4), walls_of(5)};
    for (int face = 0; face < kLightFaces; ++face) {
        SampleBounds bounds;
        for (const TileSight& sight : umbra.sights.span())
            if (sight.face == face) bounds.add(sight.bounds);
        if (bounds.x0 <= bounds.x1)
            walls[std::size_t(face)].covers =
                covers_of(world, space, walls[std::size_t(face)].face, bounds, umbra.walls.span());
    }
    umbra.hidden.resize(tiles.size());
    tasks.for_each(tiles.size(), [&](std::size_t tile, std::size_t) {
        const TileSight& sight = umbra.sights[tile];
        umbra.hidden[tile] =
            umbra.hulls[tile].empty ||
            (sight.face >= 0 && walls[std::size_t(sight.face)].hide(sight.bounds, tiles[tile]));
    });
    const auto hidden = umbra.hidden.span();
    return std::find(hidden.begin(), hidden.end(), 0) == hidden.end();
}

} // namespace firsthit
