// set_up-inl.h - sets up the edges and the depth of a batch of triangles for a cell, one triangle a
// lane.
//
// Everything is computed in double and rounded to float once. (x, y) is a sample's offset from the
// cell's middle, |x| <= hx, |y| <= hy, and u = 2^-24 is the relative error of a float.
//
// Edges. An edge function e = c + gx x + gy y is scaled so that |c| + hx |gx| + hy |gy| = 1, so that
// |e| <= 1 in the cell. The errors of e are at most
//     7 u                                   rounding c, gx, gy, x, y, and evaluating, fused or not
//     max(error_x / hx, error_y / hy)       the errors of the sample's own coordinates
//     u                                     the roundings in double. Where they might be larger, the
//                                           triangle gets edges of 0: the exact test decides all of
//                                           its samples
// Together these are cell_edge_error. A sample is certainly inside above it and certainly outside
// below its negative.
//
// Depth. w = wc + wx x + wy y. With B = |wc| + hx |wx| + hy |wy| its errors are at most
//     8 u B                                   the same roundings
//     2 u (largest |w| of a sample)           the sample's own w
//     |wx| error_x + |wy| error_y             the errors of the sample's own coordinates
//     double_error                            the roundings in double
//
// Shadow. is_shadowed, divided by positive numbers, says that a sample is shadowed if
//     w(triangle) - w(sample) > K s,    |N| = |N.x| + |N.y| + |N.z|
//     pencil with an origin:  K = |N| / |N . v0|,  s = margins / c
//     parallel pencil:        K = |N| / |N.c|,     s = margins
// The bounds shadowed_from and lit_below take the largest and the least s of the cell, and the
// errors.
#if defined(FIRSTHIT_IRREGULAR_CELLS_SET_UP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_IRREGULAR_CELLS_SET_UP_INL_H_
#undef FIRSTHIT_IRREGULAR_CELLS_SET_UP_INL_H_
#else
#define FIRSTHIT_IRREGULAR_CELLS_SET_UP_INL_H_
#endif

#include "irregular/cells/cell_kernel.h"
#include "visibility/triangle_planes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// The bound of the errors of all edge functions in a cell; see the top of the file.
inline float cell_edge_error(const CellKernelMemory& kernel)
{
    const double position_error =
        std::max(kernel.error_x / kernel.half_x, kernel.error_y / kernel.half_y);
    return float((8 * 0x1p-24 + position_error) * 1.01);
}

/// Sets up the triangles from number i of the batch on, as many as D has lanes.
template <class D>
HWY_INLINE void set_up_cell_lanes(D d, bool directional, CellKernelMemory& kernel, int i)
{
    using V = hn::Vec<D>;
    const hn::Rebind<float, D> f;
    CellBatch& batch = kernel.batch;
    const auto load = [&](int axis) {
        return hn::PromoteTo(d, hn::Load(f, batch.corner[axis] + i));
    };
    const V one = hn::Set(d, 1.0), zero = hn::Zero(d);
    const Vector3<V> v0{load(0), load(1), load(2)}, v1{load(3), load(4), load(5)},
        v2{load(6), load(7), load(8)};
    const V xm = hn::Set(d, double(kernel.middle_x)), ym = hn::Set(d, double(kernel.middle_y));
    const V hx = hn::Set(d, kernel.half_x), hy = hn::Set(d, kernel.half_y);
    const V reach_x = hn::Set(d, std::abs(kernel.middle_x) + kernel.half_x),
            reach_y = hn::Set(d, std::abs(kernel.middle_y) + kernel.half_y);
    const auto at_middle = [&](const V& x, const V& y, const V& z) {
        return hn::Add(hn::Add(hn::Mul(x, xm), hn::Mul(y, ym)), z);
    };
    const auto over_cell = [&](const V& at, const V& x, const V& y) {
        return hn::Add(hn::Abs(at), hn::Add(hn::Mul(hx, hn::Abs(x)), hn::Mul(hy, hn::Abs(y))));
    };

    // The planes through the rays' common point and each edge. The rays of a parallel pencil hit
    // the same triangles as those of a pencil with an origin if all corners have c = 1.
    const auto pencil = [&](const Vector3<V>& v) {
        return directional ? Vector3<V>{v.x, v.y, one} : v;
    };
    const Planes<V> p = planes_of(pencil(v0), pencil(v1), pencil(v2));
    V certain = hn::Abs(p.volume); // set to 0 where the volume or an edge is too inexact
    certain =
        hn::IfThenElseZero(hn::Gt(certain, hn::Mul(hn::Set(d, 0x1p-26), p.volume_size)), certain);

    auto gx0 = hn::Zero(f), gy0 = gx0, c0 = gx0, gx1 = gx0, gy1 = gx0, c1 = gx0, gx2 = gx0,
         gy2 = gx0, c2 = gx0;
    const auto edge = [&](const Vector3<V>& n, auto& gx, auto& gy, auto& c) {
        const V at = at_middle(n.x, n.y, n.z);
        const V size = over_cell(at, n.x, n.y);
        // The edge's error in double is below u if its terms are not 2^24 times larger than its
        // size: each product has one rounding, and there are two more on the way.
        const V terms = hn::Add(
            hn::Add(hn::Mul(hn::Abs(n.x), reach_x), hn::Mul(hn::Abs(n.y), reach_y)), hn::Abs(n.z));
        certain = hn::IfThenElseZero(hn::Gt(hn::Mul(size, hn::Set(d, 0x1p24)), terms), certain);
        const V scale = hn::Div(hn::CopySign(one, p.volume), size);
        gx = hn::DemoteTo(f, hn::Mul(n.x, scale));
        gy = hn::DemoteTo(f, hn::Mul(n.y, scale));
        c = hn::DemoteTo(f, hn::Mul(at, scale));
    };
    edge(p.edge[0], gx0, gy0, c0);
    edge(p.edge[1], gx1, gy1, c1);
    edge(p.edge[2], gx2, gy2, c2);

    // Depth: slopes and value of w at the middle.
    const auto e1 = sub(v1, v0), e2 = sub(v2, v0);
    const auto n = directional ? cross(e1, e2) : p.n;
    const auto n_size = directional ? cross_size(e1, e2) : p.n_size;
    const V divisor = directional ? n.z : p.volume;
    const V divisor_size = directional ? n_size.z : p.volume_size;
    const V inverse = hn::Div(one, divisor);
    const V wx = hn::Mul(n.x, inverse), wy = hn::Mul(n.y, inverse);
    V wc, terms; // terms: the sum of the sizes of wc's terms
    if (directional) {
        const V dx = hn::Sub(xm, v0.x), dy = hn::Sub(ym, v0.y);
        wc = hn::Sub(hn::Mul(hn::Add(hn::Mul(n.x, dx), hn::Mul(n.y, dy)), inverse), v0.z);
        terms = hn::Add(hn::Add(hn::Mul(n_size.x, hn::Add(hn::Abs(dx), hx)),
                            hn::Mul(n_size.y, hn::Add(hn::Abs(dy), hy))),
            hn::Mul(n_size.z, hn::Abs(v0.z)));
    } else {
        wc = hn::Mul(at_middle(n.x, n.y, n.z), inverse);
        terms = hn::Add(hn::Add(hn::Mul(n_size.x, reach_x), hn::Mul(n_size.y, reach_y)), n_size.z);
    }
    const V size = over_cell(wc, wx, wy);
    const V abs_inverse = hn::Abs(inverse);
    const V divisor_error = hn::Mul(divisor_size, abs_inverse); // relative, in units of 2^-50
    const auto u = [&](double x) { return hn::Set(d, x); };
    const V double_error = hn::Mul(u(0x1p-49),
        hn::Add(hn::Mul(terms, abs_inverse), hn::Mul(size, hn::Add(one, divisor_error))));
    const V largest_w = hn::Set(d, kernel.largest_w);
    const V position_error = hn::Add(hn::Mul(hn::Abs(wx), hn::Set(d, kernel.error_x)),
        hn::Mul(hn::Abs(wy), hn::Set(d, kernel.error_y)));
    const V error = hn::Add(hn::Add(double_error, position_error),
        hn::Add(hn::Mul(u(8 * 0x1p-24), size), hn::Mul(u(2 * 0x1p-24), largest_w)));
    const V length = hn::Add(hn::Add(hn::Abs(n.x), hn::Abs(n.y)), hn::Abs(n.z));
    const V length_size = hn::Add(hn::Add(n_size.x, n_size.y), n_size.z);
    const V k = hn::Mul(length, abs_inverse);
    const V k_error =
        hn::Mul(u(0x1p-49), hn::Add(hn::Mul(length_size, abs_inverse), hn::Mul(k, divisor_error)));
    const auto largest = [](const Vector3<V>& v) {
        return hn::Max(hn::Max(hn::Abs(v.x), hn::Abs(v.y)), hn::Abs(v.z));
    };
    const V corner = hn::Max(hn::Max(largest(v0), largest(v1)), largest(v2));
    const V most_margin = hn::Add(
        hn::Set(d, kernel.largest_margin), hn::Mul(hn::Set(d, kernel.largest_corner), corner));
    const V least_margin =
        hn::Add(hn::Set(d, kernel.least_margin), hn::Mul(hn::Set(d, kernel.least_corner), corner));
    const V most = hn::Add(hn::Mul(hn::Add(k, k_error), most_margin), error);
    const V least = hn::Sub(hn::Mul(hn::Sub(k, k_error), least_margin), error);
    // Nothing is certain if the divisor might have any value, or if a float would overflow: in a
    // small cell the slopes of w may be far larger than w.
    const auto fits = [&](const V& v) { return hn::Lt(v, u(0x1p120)); };
    const auto floats =
        hn::And(hn::And(fits(size), fits(most)), hn::And(fits(hn::Abs(wx)), fits(hn::Abs(wy))));
    const auto sane =
        hn::And(hn::Gt(certain, zero), hn::And(hn::Lt(divisor_error, u(0x1p26)), floats));
    const V infinite = hn::Inf(d);
    const V from =
        hn::IfThenElse(sane, hn::Add(most, hn::Mul(hn::Abs(most), u(0x1p-22))), infinite);
    const V below = hn::IfThenElse(
        sane, hn::Sub(least, hn::Mul(hn::Abs(least), u(0x1p-22))), hn::Neg(infinite));
    const auto sanely = [&](const V& v) { return hn::IfThenElseZero(sane, v); };

    const auto store = [&](auto v, float* to) { hn::Store(v, f, to + i); };
    const auto safe = hn::Ne(hn::DemoteTo(f, hn::IfThenElseZero(sane, one)), hn::Zero(f));
    const auto store_edge = [&](auto v, float* to) { store(hn::IfThenElseZero(safe, v), to); };
    store_edge(gx0, batch.gx[0]), store_edge(gy0, batch.gy[0]), store_edge(c0, batch.c[0]);
    store_edge(gx1, batch.gx[1]), store_edge(gy1, batch.gy[1]), store_edge(c1, batch.c[1]);
    store_edge(gx2, batch.gx[2]), store_edge(gy2, batch.gy[2]), store_edge(c2, batch.c[2]);
    store(hn::DemoteTo(f, sanely(wx)), batch.wx);
    store(hn::DemoteTo(f, sanely(wy)), batch.wy);
    store(hn::DemoteTo(f, sanely(wc)), batch.wc);
    store(hn::DemoteTo(f, from), batch.shadowed_from);
    store(hn::DemoteTo(f, below), batch.lit_below);
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif
