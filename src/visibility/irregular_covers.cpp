// irregular_covers.cpp - large triangles that shadow whole patches and cells of samples.
//
// A triangle shadows every point of a box of the face, between two depths, where its edges are
// positive at the box's corners and it is nearer to the light there than the nearest point, by more
// than the margin: edges and depth are affine. All in double, with room for the roundings.
#include "visibility/irregular_covers.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace firsthit {
namespace {

constexpr double kSmallestCover = 1.0 / 64; // of the samples' bounds
constexpr double kRoom = 0x1p-20;           // for roundings, far more than they are

double covered_area(const SeenTriangle& seen, const SampleBounds& bounds)
{
    const double width =
        double(std::min(seen.x1, bounds.x1)) - double(std::max(seen.x0, bounds.x0));
    const double height =
        double(std::min(seen.y1, bounds.y1)) - double(std::max(seen.y0, bounds.y0));
    return width * height;
}

struct Place {
    double x, y;
};

/// The corners of the bounds, a little further out: samples' places are rounded.
std::array<Place, 4> corners_of(const SampleBounds& b)
{
    const auto low = [](float v) { return double(v) - 0x1p-22 * std::abs(double(v)); };
    const auto high = [](float v) { return double(v) + 0x1p-22 * std::abs(double(v)); };
    return {{{low(b.x0), low(b.y0)}, {high(b.x1), low(b.y0)}, {low(b.x0), high(b.y1)},
        {high(b.x1), high(b.y1)}}};
}

/// n . (x, y, 1), or -infinity where its sign is not certain.
double certain_dot(const glm::dvec3& n, const Place& at)
{
    const double x = n.x * at.x, y = n.y * at.y;
    const double sum = (x + y) + n.z;
    const double size = std::abs(x) + std::abs(y) + std::abs(n.z);
    return sum > kRoom * size ? sum : -std::numeric_limits<double>::infinity();
}

bool shadows_box(const LightMesh& mesh, std::uint32_t triangle, const SampleBounds& bounds)
{
    const bool directional = mesh.space.directional;
    const Corners corners = mesh.corners(triangle);
    std::array<glm::dvec3, 3> v, pencil;
    for (std::size_t k = 0; k < 3; ++k) {
        v[k] = glm::dvec3(mesh.face.seen_from(corners[k]));
        pencil[k] = directional ? glm::dvec3(v[k].x, v[k].y, 1) : v[k];
    }
    const double volume = glm::dot(pencil[0], glm::cross(pencil[1], pencil[2]));
    const double facing = volume > 0 ? 1 : -1;
    const std::array<Place, 4> places = corners_of(bounds);
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 edge = facing * glm::cross(pencil[k], pencil[(k + 1) % 3]);
        for (const Place& place : places)
            if (!(certain_dot(edge, place) > 0)) return false;
    }

    const glm::dvec3 n = glm::cross(v[1] - v[0], v[2] - v[0]);
    const double divisor = directional ? n.z : volume;
    const double nearest = bounds.nearest_w;
    double largest = 1; // of a point's coordinates, over its c for a point light
    if (directional)
        largest = std::max({std::abs(double(bounds.x0)), std::abs(double(bounds.x1)),
            std::abs(double(bounds.y0)), std::abs(double(bounds.y1)), std::abs(nearest),
            std::abs(double(bounds.farthest_w))});
    const double reach = double(mesh.space.reach) * (directional ? 1 : nearest);
    const double corner = double(corner_margin(corners)) * (directional ? 1 : nearest);
    const double margin = (double(kShadowMargin) * (2 * largest + reach) + corner) *
                          (std::abs(n.x) + std::abs(n.y) + std::abs(n.z)) / std::abs(divisor);
    for (const Place& place : places) {
        double w, size;
        if (directional) {
            const double x = n.x * (place.x - v[0].x) / n.z, y = n.y * (place.y - v[0].y) / n.z;
            w = x + y - v[0].z;
            size = std::abs(x) + std::abs(y) + std::abs(v[0].z);
        } else {
            const double x = n.x * place.x / volume, y = n.y * place.y / volume;
            w = x + y + n.z / volume;
            size = std::abs(x) + std::abs(y) + std::abs(n.z / volume);
        }
        if (!(w - nearest > margin * (1 + kRoom) + kRoom * (size + std::abs(nearest))))
            return false;
    }
    return true;
}

/// Whether one of the samples lies on the triangle.
bool is_item(
    std::uint32_t triangle, std::span<const IrregularSample> samples, const LightPoints& points)
{
    if (!points.item) return false;
    bool found = false;
    const std::size_t between = samples.back().id - std::size_t(samples.front().id);
    if (points.ids_rise && between < 4 * samples.size()) {
        // All lie between two: no need to look at each sample.
        for (std::size_t id = samples.front().id; id <= samples.back().id; ++id)
            found |= points.item[id] == triangle;
    } else {
        for (const IrregularSample& sample : samples) found |= points.item[sample.id] == triangle;
    }
    return found;
}

} // namespace

CoverList find_covers(
    const LightMesh& mesh, std::span<const SampleRange> ranges, const SampleBounds& bounds)
{
    CoverList covers;
    const double whole =
        (double(bounds.x1) - double(bounds.x0)) * (double(bounds.y1) - double(bounds.y0));
    double least = kSmallestCover * whole;
    for (const SampleRange& range : ranges) {
        for (const SeenTriangle& seen : mesh.in_view.span().subspan(range.first, range.count)) {
            if (!(covered_area(seen, bounds) > least)) continue;
            if (covers.count < CoverList::kMost) {
                covers.triangle[std::size_t(covers.count++)] = seen;
                continue;
            }
            const auto area = [&](const SeenTriangle& s) { return covered_area(s, bounds); };
            auto& smallest = *std::min_element(covers.triangle.begin(), covers.triangle.end(),
                [&](const auto& a, const auto& b) { return area(a) < area(b); });
            least = std::max(least, area(smallest));
            if (area(seen) > area(smallest)) smallest = seen;
        }
    }
    return covers;
}

bool is_covered(const LightMesh& mesh, const CoverList& covers, const SampleBounds& b,
    std::span<const IrregularSample> samples, const LightPoints& points)
{
    if (!std::isfinite(b.farthest_w) || !std::isfinite(b.nearest_w)) return false;
    for (int k = 0; k < covers.count; ++k) {
        const SeenTriangle& seen = covers.triangle[std::size_t(k)];
        const bool around =
            seen.x0 <= b.x0 && seen.x1 >= b.x1 && seen.y0 <= b.y0 && seen.y1 >= b.y1;
        if (around && seen.nearest_w > b.nearest_w && shadows_box(mesh, seen.triangle, b) &&
            !is_item(seen.triangle, samples, points))
            return true;
    }
    return false;
}

} // namespace firsthit
