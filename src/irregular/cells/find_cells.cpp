// find_cells.cpp - finds the cells of samples and triangles, one register at a time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "irregular/cells/find_cells.cpp"
#include "base/simd.h"

#include "irregular/cells/cells.h"
#include "irregular/mesh/projected_triangles-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

using Reals = ProjectedTag;
using Whole = hn::RebindToSigned<Reals>;

/// Samples [k, k + lanes). Lanes past the end repeat sample k.
struct SampleRegister {
    hn::Vec<Reals> x, y, w;

    HWY_INLINE SampleRegister(std::span<const IrregularSample> samples, std::size_t k)
    {
        const Reals d;
        auto id = hn::Zero(d);
        const std::size_t lanes = hn::Lanes(d);
        if (k + lanes <= samples.size()) {
            hn::LoadInterleaved4(d, &samples[k].x, x, y, w, id);
            return;
        }
        IrregularSample last[16];
        for (std::size_t i = 0; i < lanes; ++i)
            last[i] = samples[k + i < samples.size() ? k + i : k];
        hn::LoadInterleaved4(d, &last[0].x, x, y, w, id);
    }
};

/// The columns or rows of a register of coordinates as floats in [0, count - 1], to be truncated. 0
/// for NaN.
template <class V>
HWY_INLINE V cell_along(V v, float start, float scale, int count)
{
    const Reals d;
    const V at = hn::Mul(hn::Sub(v, hn::Set(d, start)), hn::Set(d, scale));
    const V inside = hn::IfThenElseZero(hn::Gt(at, hn::Zero(d)), at);
    return hn::Min(inside, hn::Set(d, float(count - 1)));
}

void sample_cells(
    const CellGrid& grid, std::span<const IrregularSample> samples, std::uint16_t* cell)
{
    const Reals d;
    const Whole w;
    const hn::Rebind<std::uint16_t, Reals> narrow;
    for (std::size_t k = 0; k < samples.size(); k += hn::Lanes(d)) {
        const SampleRegister s(samples, k);
        const auto column = hn::ConvertTo(w, cell_along(s.x, grid.x0, grid.scale_x, grid.columns));
        const auto row = hn::ConvertTo(w, cell_along(s.y, grid.y0, grid.scale_y, grid.rows));
        const auto number = hn::Add(hn::Mul(row, hn::Set(w, grid.columns)), column);
        hn::StoreU(hn::DemoteTo(narrow, number), narrow, cell + k);
    }
}

void triangle_cells(const CellGrid& grid, const SampleBounds& bounds,
    std::span<const ProjectedTriangle> triangles, CellRect* rect)
{
    const Reals d;
    const Whole w;
    for (std::size_t k = 0; k < triangles.size(); k += hn::Lanes(d)) {
        const ProjectedTriangles box = load_projected(triangles, k);
        const auto column = [&](auto v) {
            return hn::ConvertTo(w, cell_along(v, grid.x0, grid.scale_x, grid.columns));
        };
        const auto row = [&](auto v) {
            return hn::ConvertTo(w, cell_along(v, grid.y0, grid.scale_y, grid.rows));
        };
        const auto none = hn::Set(w, 0x000000FF); // column0 = 255 > column1 = 0
        const auto packed = hn::Or(hn::Or(column(box.x0), hn::ShiftLeft<8>(row(box.y0))),
            hn::Or(hn::ShiftLeft<16>(column(box.x1)), hn::ShiftLeft<24>(row(box.y1))));
        const auto chosen = hn::IfThenElse(hn::RebindMask(w, may_hit(box, bounds)), packed, none);
        hn::StoreU(chosen, w, reinterpret_cast<std::int32_t*>(rect + k));
    }
}

SampleBounds sample_bounds(std::span<const IrregularSample> samples)
{
    const Reals d;
    const auto infinite = hn::Inf(d), least = hn::Neg(infinite);
    auto x0 = infinite, y0 = infinite, x1 = least, y1 = least, far = infinite, near = least;
    for (std::size_t k = 0; k < samples.size(); k += hn::Lanes(d)) {
        const SampleRegister s(samples, k);
        x0 = hn::Min(x0, s.x), x1 = hn::Max(x1, s.x);
        y0 = hn::Min(y0, s.y), y1 = hn::Max(y1, s.y);
        const auto w = hn::IfThenElse(hn::Eq(s.w, s.w), s.w, least);
        far = hn::Min(far, w), near = hn::Max(near, w);
    }
    const auto low = [&](auto v) { return hn::GetLane(hn::MinOfLanes(d, v)); };
    const auto high = [&](auto v) { return hn::GetLane(hn::MaxOfLanes(d, v)); };
    return {low(x0), low(y0), high(x1), high(y1), low(far), high(near)};
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(sample_cells);
HWY_EXPORT(triangle_cells);
HWY_EXPORT(sample_bounds);

void find_sample_cells(
    const CellGrid& grid, std::span<const IrregularSample> from, std::uint16_t* cell)
{
    HWY_DYNAMIC_DISPATCH(sample_cells)(grid, from, cell);
}

void find_triangle_cells(const CellGrid& grid, const SampleBounds& bounds,
    std::span<const ProjectedTriangle> from, CellRect* rect)
{
    HWY_DYNAMIC_DISPATCH(triangle_cells)(grid, bounds, from, rect);
}

SampleBounds bounds_of(std::span<const IrregularSample> samples)
{
    return HWY_DYNAMIC_DISPATCH(sample_bounds)(samples);
}

} // namespace firsthit
#endif
