// irregular_covers.cpp - large triangles that shadow whole patches and cells of samples.
//
// A triangle shadows every point of a box of the face, between two depths, where its edges are
// positive at the box's corners and it is nearer to the light there than the nearest point, by more
// than the margin: edges and depth are affine. All in double, and nothing is certain that roundings
// might change: not on which side of a triangle a light is that lies nearly in its plane.
#include "visibility/irregular_covers.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace firsthit {
namespace {

using glm::dvec3;

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

/// The corners of the bounds, a little further out: samples' places are rounded, tiny ones to 0.
std::array<Place, 4> corners_of(const SampleBounds& b)
{
    const auto out = [](float v) { return 0x1p-22 * std::abs(double(v)) + 0x1p-140; };
    const double x0 = double(b.x0) - out(b.x0), x1 = double(b.x1) + out(b.x1),
                 y0 = double(b.y0) - out(b.y0), y1 = double(b.y1) + out(b.y1);
    return {{{x0, y0}, {x1, y0}, {x0, y1}, {x1, y1}}};
}

/// A value, and what its roundings are relative to.
struct Rounded {
    double value = 0, size = 0;

    /// 0 where it may be.
    int sign() const { return std::abs(value) > kRoom * size ? value > 0 ? 1 : -1 : 0; }
};

struct RoundedVector {
    dvec3 value{0}, size{0};
};

RoundedVector cross(const dvec3& a, const dvec3& b)
{
    const dvec3 p = glm::abs(a), q = glm::abs(b);
    return {
        glm::cross(a, b), {p.y * q.z + p.z * q.y, p.z * q.x + p.x * q.z, p.x * q.y + p.y * q.x}};
}

Rounded dot(const RoundedVector& n, const dvec3& p)
{
    return {glm::dot(n.value, p), glm::dot(n.size, glm::abs(p))};
}

/// A product of two corners: each component is the difference of two exact products.
RoundedVector corner_product(const dvec3& a, const dvec3& b)
{
    const dvec3 n = glm::cross(a, b);
    return {n, glm::abs(n)};
}

bool shadows_box(const LightMesh& mesh, std::uint32_t triangle, const SampleBounds& bounds)
{
    const bool directional = mesh.space.directional;
    const Corners corners = mesh.corners(triangle);
    std::array<dvec3, 3> v, pencil;
    for (std::size_t k = 0; k < 3; ++k) {
        v[k] = dvec3(mesh.face.seen_from(corners[k]));
        pencil[k] = directional ? dvec3(v[k].x, v[k].y, 1) : v[k];
    }
    const Rounded volume = dot(corner_product(pencil[1], pencil[2]), pencil[0]);
    if (volume.sign() == 0) return false;
    const std::array<Place, 4> places = corners_of(bounds);
    for (std::size_t k = 0; k < 3; ++k) {
        const RoundedVector edge = corner_product(pencil[k], pencil[(k + 1) % 3]);
        for (const Place& at : places)
            if (dot(edge, {at.x, at.y, 1}).sign() != volume.sign()) return false;
    }

    const RoundedVector n = cross(v[1] - v[0], v[2] - v[0]);
    const Rounded divisor = directional ? Rounded{n.value.z, n.size.z} : volume;
    if (divisor.sign() == 0) return false;
    const double nearest = bounds.nearest_w;
    // Of a point's coordinates, over its c for a point light.
    const double largest = std::max(
        {std::abs(double(bounds.x0)), std::abs(double(bounds.x1)), std::abs(double(bounds.y0)),
            std::abs(double(bounds.y1)), directional ? std::abs(nearest) : 1.0,
            directional ? std::abs(double(bounds.farthest_w)) : 1.0});
    const double per_margin = directional ? 1 : nearest;
    const double margin = double(kShadowMargin) * 2 * largest +
                          (double(kShadowMargin) * double(mesh.space.reach) +
                              double(corner_margin(corners)) + kMarginUnderflow) *
                              per_margin;
    const double length = n.size.x + n.size.y + n.size.z; // or a little more
    for (const Place& at : places) {
        const Rounded height =
            directional ? dot(n, {at.x - v[0].x, at.y - v[0].y, 0}) : dot(n, {at.x, at.y, 1});
        const double base = directional ? v[0].z : 0;
        const double w = height.value / divisor.value - base;
        const double size = (height.size + margin * length) / std::abs(divisor.value) +
                            std::abs(base) + std::abs(nearest);
        if (!(w - nearest > margin * length / std::abs(divisor.value) + kRoom * size)) return false;
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

/// Keeps the largest covers that it is offered.
class CoverChoice {
  public:
    explicit CoverChoice(const SampleBounds& bounds) : bounds_(bounds)
    {
        least_ = kSmallestCover * (double(bounds.x1) - double(bounds.x0)) *
                 (double(bounds.y1) - double(bounds.y0));
    }

    void offer(const SeenTriangle& seen)
    {
        if (!(covered_area(seen, bounds_) > least_)) return;
        if (covers.count < CoverList::kMost) {
            covers.triangle[std::size_t(covers.count++)] = seen;
            return;
        }
        const auto area = [&](const SeenTriangle& s) { return covered_area(s, bounds_); };
        auto& smallest = *std::min_element(covers.triangle.begin(), covers.triangle.end(),
            [&](const auto& a, const auto& b) { return area(a) < area(b); });
        least_ = std::max(least_, area(smallest));
        if (area(seen) > area(smallest)) smallest = seen;
    }

    CoverList covers;

  private:
    SampleBounds bounds_;
    double least_;
};

} // namespace

CoverList find_covers(const LightMesh& mesh, std::span<const SampleRange> ranges,
    const SampleBounds& bounds, Buffer<CoverList>& of_range, Tasks& tasks)
{
    of_range.resize(ranges.size());
    tasks.for_each(ranges.size(), [&](std::size_t k, std::size_t) {
        CoverChoice choice(bounds);
        for (const SeenTriangle& seen :
            mesh.in_view.span().subspan(ranges[k].first, ranges[k].count))
            choice.offer(seen);
        of_range[k] = choice.covers;
    });
    CoverChoice choice(bounds);
    for (const CoverList& some : of_range.span())
        for (const SeenTriangle& seen : some.span()) choice.offer(seen);
    return choice.covers;
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
