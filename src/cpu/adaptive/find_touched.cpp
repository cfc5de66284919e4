// find_touched.cpp - finds the pixels that triangles touch without being seen at their centres.
//
// A triangle touches a pixel if it meets the square around the pixel's centre. Only triangles count
// that are not certainly behind what the centre sees, and not a part of the same surface. Everything
// here is in float or double without exactness: a wrong answer costs time, or leaves a pixel with the
// colour of its centre.
#include "cpu/adaptive/edge_finder.h"

#include "base/stopwatch.h"
#include "cpu/adaptive/item_plane.h"
#include "exact/hit.h"
#include "visibility/bin/careful_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace firsthit {
namespace {

constexpr std::size_t kRange = 2048; // triangles of a task

/// Squares are wider than half a pixel by this, against rounding.
constexpr double kReach = 0.5 + 1.0 / 256;

/// A triangle's edges on the picture: x X + y Y + z for the ray of direction (X, Y, 1), positive inside.
struct Outline {
    glm::dvec3 edge[3];

    explicit Outline(const Corners& c)
    {
        const glm::dvec3 a(c[0]), b(c[1]), d(c[2]);
        edge[0] = glm::cross(a, b), edge[1] = glm::cross(b, d), edge[2] = glm::cross(d, a);
        const double sign = glm::dot(edge[0], d) < 0 ? -1 : 1;
        for (glm::dvec3& e : edge) e *= sign;
    }

    /// Whether it may meet the square around a direction: false if an edge separates them.
    bool meets(const glm::dvec2& d, double half) const
    {
        for (const glm::dvec3& e : edge)
            if (e.x * d.x + e.y * d.y + e.z + half * (std::abs(e.x) + std::abs(e.y)) < 0)
                return false;
        return true;
    }
};

/// Pixels or blocks of the part; x1 and y1 are inside.
struct Rectangle {
    int x0, y0, x1, y1;
};

/// A triangle that may be seen.
struct Candidate {
    std::uint32_t triangle;
    float nearest_w; // at least its 1/t
    ItemPlane plane;
};

/// The search through triangles.
struct Search {
    const EdgeSight& sight;
    PixelMarks& marks;
    const EyeMesh& mesh;
    const Pencil& pencil;
    const Scene& scene;
    NormalTransform to_world;
    int left, top; // the part's first pixel in the region

    int columns() const { return (marks.region.width + kBlock - 1) / kBlock; }

    /// Whether a triangle shows something else, in the square around a pixel, than what is seen
    /// there at the centre.
    bool shows_more(const Candidate& a, std::uint32_t seen, const glm::vec2& d) const
    {
        if (seen == kNoItem) return true;
        const ItemPlane b(corners_of(mesh, seen));
        const float wb = b.inverse_depth(d), difference = a.plane.inverse_depth(d) - wb;
        const float slack = 0.5f * (std::abs(a.plane.x - b.x) + std::abs(a.plane.y - b.y));
        const float ahead = std::min(difference + slack, a.nearest_w - (wb - b.reach()));
        if (ahead < -kSameDepth * wb) return false; // behind
        if (scene.owner[seen] != scene.owner[a.triangle]) return true;
        if (difference - slack > a.plane.reach() + b.reach() + kSameDepth * wb) return true;
        return !are_close(a.plane.normal(to_world), b.normal(to_world));
    }

    void test_pixels(const Candidate& a, const Outline& outline, const Rectangle& pixels) const
    {
        const auto width = std::size_t(marks.region.width);
        for (int y = pixels.y0; y <= pixels.y1; ++y) {
            const std::size_t row = std::size_t(top + y) * width;
            for (int x = pixels.x0; x <= pixels.x1; ++x) {
                const std::size_t at = row + std::size_t(left + x);
                const std::uint32_t item = sight.kind[at] == kNoItem ? kNoItem : sight.item[at];
                const int px = marks.region.x + left + x, py = marks.region.y + top + y;
                if (item == a.triangle || marks.has(px, py)) continue;
                const glm::dvec2 d(pencil.x0 + x, pencil.y0 + y);
                if (outline.meets(d, kReach) && shows_more(a, item, glm::vec2(d)))
                    marks.mark(px, py);
            }
        }
    }

    /// Whether a block certainly hides a triangle, or sees nothing else.
    static bool hides(const BlockSight& block, std::uint32_t triangle, float nearest_w)
    {
        return nearest_w < block.least_w * (1 - 0x1p-10f) || block.item == triangle;
    }

    /// Whether a triangle goes on with the one surface that all pixels of a block see.
    bool goes_on(const BlockSight& block, const Candidate& a) const
    {
        return block.least_w > 0 && block.owner == scene.owner[a.triangle] &&
               a.nearest_w <= block.most_w * (1 + 0x1p-7f) &&
               are_close(-a.plane.normal(to_world), block.normal);
    }

    void test(std::uint32_t t) const
    {
        const Corners c = corners_of(mesh, t);
        const float nearest = std::min({c[0].z, c[1].z, c[2].z});
        Interval x, y;
        if (nearest > 0) {
            const float a = 1 / c[0].z, b = 1 / c[1].z, d = 1 / c[2].z;
            x = across(c[0].x * a, c[1].x * b, c[2].x * d);
            y = across(c[0].y * a, c[1].y * b, c[2].y * d);
        } else {
            x = project_front(c, 0), y = project_front(c, 1);
        }
        // The holes of cut-outs are no surfaces: only small ones count, as if they had none.
        const double extent = std::max(x.high - x.low, y.high - y.low);
        if (!(extent < 3) && mesh.cutouts.has(t)) return;
        // The first and the last pixel whose square a range of directions meets. NaN gives none.
        if (!(x.low <= pencil.x0 + pencil.width && y.low <= pencil.y0 + pencil.height)) return;
        const auto first = [](double low, double from) {
            return int(std::ceil(std::max(low - from - kReach, 0.0)));
        };
        const auto last = [](double high, double from, int size) {
            const double at = std::min(high - from + kReach, double(size - 1));
            return at >= 0 ? int(at) : -1;
        };
        const Rectangle box{first(x.low, pencil.x0), first(y.low, pencil.y0),
            last(x.high, pencil.x0, pencil.width), last(y.high, pencil.y0, pencil.height)};
        if (box.x0 > box.x1 || box.y0 > box.y1) return;
        test_blocks(t, c, nearest > 0 ? 1 / nearest : std::numeric_limits<float>::infinity(), box);
    }

    static Interval across(float a, float b, float c)
    {
        return {std::min({a, b, c}), std::max({a, b, c})};
    }

    void test_blocks(std::uint32_t t, const Corners& c, float nearest_w, const Rectangle& box) const
    {
        const int bx0 = (left + box.x0) / kBlock, bx1 = (left + box.x1) / kBlock;
        const int by0 = (top + box.y0) / kBlock, by1 = (top + box.y1) / kBlock;
        const bool large = bx1 - bx0 > 1 || by1 - by0 > 1;
        std::optional<Candidate> a;
        std::optional<Outline> outline;
        for (int by = by0; by <= by1; ++by) {
            for (int bx = bx0; bx <= bx1; ++bx) {
                const BlockSight& block = sight.block[std::size_t(by * columns() + bx)];
                if (hides(block, t, nearest_w)) continue;
                if (!a) {
                    a = Candidate{t, nearest_w, ItemPlane(c)};
                    if (!(std::abs(a->plane.z) < std::numeric_limits<float>::infinity()))
                        return; // seen from its edge
                }
                if (goes_on(block, *a)) continue;
                if (!outline) outline.emplace(c);
                const int x = bx * kBlock - left, y = by * kBlock - top;
                if (large && !outline->meets({pencil.x0 + x + 3.5, pencil.y0 + y + 3.5}, 4.01))
                    continue;
                test_pixels(*a, *outline,
                    {std::max(box.x0, x), std::max(box.y0, y), std::min(box.x1, x + kBlock - 1),
                        std::min(box.y1, y + kBlock - 1)});
            }
        }
    }
};

} // namespace

void EdgeFinder::find_touched(const Region& part, const ViewMemory& view)
{
    const int left = part.x - marks_.region.x, top = part.y - marks_.region.y;
    first_ray_ = {float(view.pencil.x0 - left), float(view.pencil.y0 - top)};
    if (!in_first_layer()) return;
    Stopwatch watch;
    const Search search{memory_.first, marks_, view, view.pencil, *world_.scene,
        NormalTransform(view.pencil), left, top};
    tasks_.for_ranges(view.index.size(), kRange, [&](std::size_t first, std::size_t last) {
        for (std::size_t t = first; t < last; ++t) search.test(std::uint32_t(t));
    });
    ms_ += watch.lap_ms();
}

} // namespace firsthit
