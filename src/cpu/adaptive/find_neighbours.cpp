// find_neighbours.cpp - finds neighbouring pixels that see different things.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cpu/adaptive/find_neighbours.cpp"
#include "base/simd.h"

#include "base/stopwatch.h"
#include "cpu/adaptive/active_runs.h"
#include "cpu/adaptive/edge_finder.h"
#include "cpu/adaptive/item_plane.h"
#include "exact/cutouts.h"
#include "exact/hit.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#ifndef FIRSTHIT_FIND_NEIGHBOURS_ONCE
#define FIRSTHIT_FIND_NEIGHBOURS_ONCE
namespace firsthit {

/// Rows of the picture, from the same pixel on: of the pixels and of those above and below. Where these
/// are missing, the row itself.
struct SightRows {
    const std::uint32_t *kind, *kind_below;
    const float *w_above, *w, *w_below;
};

} // namespace firsthit
#endif

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// A bit for each of the first `count` pixels of rows, at most 32, whose kind is another than that of a
/// neighbour to the right or below. May read kinds of a pixel before the first one and of those after.
std::uint32_t other_kinds(const SightRows& rows, std::size_t count)
{
    const hn::CappedTag<std::uint32_t, 8> d;
    std::uint32_t result = 0;
    for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
        const auto own = hn::LoadU(d, rows.kind + k);
        const auto other = [&](const std::uint32_t* p) { return hn::Xor(own, hn::LoadU(d, p)); };
        const auto any = hn::Or(hn::Or(other(rows.kind + k + 1), other(rows.kind_below + k)),
            hn::Or(other(rows.kind_below + k + 1), other(rows.kind_below + k - 1)));
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, hn::Ne(any, hn::Zero(d)), bits);
        result |= std::uint32_t(bits[0]) << k;
    }
    return count < 32 ? result & ((1u << count) - 1) : result;
}

/// The same of pixels where 1/t, which is affine on a plane, bends: by more than most_bend of it.
std::uint32_t bends(const SightRows& rows, std::size_t count, float most_bend)
{
    const hn::CappedTag<float, 8> d;
    std::uint32_t result = 0;
    for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
        const auto own = hn::LoadU(d, rows.w + k), twice = hn::Add(own, own);
        const auto line = [&](const float* a, const float* b) {
            return hn::Abs(hn::Sub(hn::Add(hn::LoadU(d, a + k), hn::LoadU(d, b + k)), twice));
        };
        const auto most =
            hn::Max(hn::Max(line(rows.w - 1, rows.w + 1), line(rows.w_above, rows.w_below)),
                hn::Max(line(rows.w_above - 1, rows.w_below + 1),
                    line(rows.w_above + 1, rows.w_below - 1)));
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, hn::Gt(most, hn::Mul(own, hn::Set(d, most_bend))), bits);
        result |= std::uint32_t(bits[0]) << k;
    }
    return count < 32 ? result & ((1u << count) - 1) : result;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(other_kinds);
HWY_EXPORT(bends);

namespace {

/// Of two neighbours.
struct Sides {
    bool first, second;
};

/// The picture that was recorded.
struct Sight {
    const EdgeSight& seen;
    const EyeMesh& mesh;
    int width, height;
    glm::vec2 first; // direction of the first pixel's ray
    bool touches;    // whether find_touched looks at what is seen

    std::size_t at(int x, int y) const
    {
        return std::size_t(y) * std::size_t(width) + std::size_t(x);
    }

    std::uint32_t kind(int x, int y) const { return seen.kind[at(x, y)]; }
    std::uint32_t item(int x, int y) const
    {
        return kind(x, y) == kNoItem ? kNoItem : seen.item[at(x, y)];
    }

    /// In which of two neighbours' squares there may be an edge between what they see. Where one surface
    /// is clearly before the other, its border is in the square of the pixel that sees it, or else its
    /// triangles touch the other one's square (find_touched).
    Sides edge_sides(int x, int y, int x2, int y2) const
    {
        const std::uint32_t a = item(x, y), b = item(x2, y2);
        if (a == b) return {false, false};
        if (a == kNoItem || b == kNoItem)
            return {a != kNoItem || !touches, b != kNoItem || !touches};
        const ItemPlane plane_a(corners_of(mesh, a)), plane_b(corners_of(mesh, b));
        const bool other = kind(x, y) != kind(x2, y2);
        // Surfaces that meet are in turn before one another there, or close.
        const glm::vec2 p = first + glm::vec2(x, y), q = first + glm::vec2(x2, y2);
        const float at_p = plane_a.inverse_depth(p) - plane_b.inverse_depth(p);
        const float at_q = plane_a.inverse_depth(q) - plane_b.inverse_depth(q);
        const float gap = std::min(std::abs(at_p), std::abs(at_q));
        const float least =
            plane_a.reach() + plane_b.reach() + kSameDepth * plane_a.inverse_depth(p);
        if ((at_p < 0) != (at_q < 0) || gap <= least) return {other, other};
        return {at_p > 0 || !touches, at_p < 0 || !touches};
    }
};

/// The picture's rows around pixel (x, y).
SightRows rows_at(const Sight& sight, int x, int y)
{
    const int above = std::max(y - 1, 0), below = std::min(y + 1, sight.height - 1);
    const auto kind = [&](int row) { return sight.seen.kind.data() + sight.at(x, row); };
    const auto w = [&](int row) { return sight.seen.w.data() + sight.at(x, row); };
    return {kind(y), kind(below), w(above), w(y), w(below)};
}

} // namespace

void EdgeFinder::find_neighbours(const ViewMemory& view)
{
    const bool touches = in_first_layer();
    Stopwatch watch;
    const Region& region = marks_.region;
    const int width = region.width, height = region.height;
    const Pencil& pencil = view.pencil;
    // Two planes at 30 degrees, seen from f pixels away, change 1/t by tan(30)/f of it at least over a
    // pixel, of which one of four directions shows 0.92, and one of two neighbours half. Surfaces that
    // do not meet bend it by more.
    // Of parallel rays 1/t is from 1 to 2, and changes by tan(30) / (f scale).
    const double f = std::max(pencil.f.x, pencil.f.y) * (pencil.parallel ? 2 * pencil.scale : 1.0);
    const float most_bend = std::max(0.25f / float(f), 2e-6f);
    const Sight sight{*sight_, view, width, height, first_ray_, touches};
    const auto compare = [&](int x, int y, int x2, int y2) {
        const Sides sides = sight.edge_sides(x, y, x2, y2);
        if (sides.first) marks_.mark(region.x + x, region.y + y);
        if (sides.second) marks_.mark(region.x + x2, region.y + y2);
    };
    const auto compare_kinds = [&](int x, int y) {
        constexpr int kSteps[4][2] = {{1, 0}, {-1, 1}, {0, 1}, {1, 1}};
        for (const auto& [dx, dy] : kSteps) {
            const int x2 = x + dx, y2 = y + dy;
            if (x2 < 0 || x2 >= width || y2 >= height) continue;
            if (sight.kind(x, y) != sight.kind(x2, y2)) compare(x, y, x2, y2);
        }
    };
    const auto compare_depths = [&](int x, int y) {
        if (sight.kind(x, y) == kNoItem) return;
        for (int y2 = std::max(y - 1, 0); y2 <= std::min(y + 1, height - 1); ++y2)
            for (int x2 = std::max(x - 1, 0); x2 <= std::min(x + 1, width - 1); ++x2)
                if (sight.kind(x, y) == sight.kind(x2, y2)) compare(x, y, x2, y2);
    };
    for_active_runs(tasks_, *sight_, region, false, [&](const PixelRun& run, std::size_t) {
        for (int y = run.top; y < run.bottom; ++y) {
            // Half of what a bend needs is missing at the picture's sides: always look.
            if (run.begin == 0) compare_kinds(0, y), compare_depths(0, y);
            if (run.end == width) compare_kinds(width - 1, y), compare_depths(width - 1, y);
            const int begin = std::max(run.begin, 1), end = std::min(run.end, width - 1);
            for (int x = begin; x < end; x += 32) {
                const SightRows rows = rows_at(sight, x, y);
                const auto count = std::size_t(std::min(32, end - x));
                for (std::uint32_t set = HWY_DYNAMIC_DISPATCH(other_kinds)(rows, count); set;
                     set &= set - 1)
                    compare_kinds(x + std::countr_zero(set), y);
                for (std::uint32_t set = HWY_DYNAMIC_DISPATCH(bends)(rows, count, most_bend); set;
                     set &= set - 1)
                    compare_depths(x + std::countr_zero(set), y);
            }
        }
    });
    if (has_blended_triangles(*world_.scene)) memory_.other.resize(width, height);
    sight_ = &memory_.other;
    ms_ += watch.lap_ms();
}

} // namespace firsthit
#endif
