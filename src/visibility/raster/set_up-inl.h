// set_up-inl.h - computes the edge functions and the depths of a batch of triangles, one in each
// lane.
//
// Everything is computed in double and rounded once to float. The errors, with u = 2^-24:
//
// Edges. c, gx and gy are rounded once (u each). Evaluating e takes two products and two sums. So
// |computed e - e| <= 5 u (|c| + X |gx| + Y |gy|), where X and Y are the largest offsets; the steps
// of the tiny kernel add less than u. Edges are scaled so that the bracket is 1, and one constant
// bounds them all. The computation in double adds less than 2^-29: the products of a x b are exact,
// so each term has at most four roundings of 2^-53, and |nx X0| + |ny Y0| + |nz| is at most 2^22
// times the bracket for the largest picture with the farthest principal point (|X0| < 2^22).
//
// Depth. It is not scaled. The error is 5 u (|wc| + X |wx| + Y |wy|), which is at most 15 u w if
// the bracket is at most 3 w. That is tested with the triangle's least w, which is 1 / its farthest
// z. The computation in double is tested to add less than 2.5 u w, and the steps of the tiny kernel
// add 3 u w. All together is less than kDepthError = 24 u.
#if defined(FIRSTHIT_SET_UP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SET_UP_INL_H
#undef FIRSTHIT_SET_UP_INL_H
#else
#define FIRSTHIT_SET_UP_INL_H
#endif

#include <hwy/highway.h>

#include "visibility/raster/raster_scratch.h"
#include "visibility/triangle_planes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Bound of an edge's error at a corner of a box, which takes two more sums than at a sample.
constexpr float kBoxError = 12 * 0x1p-24f;

/// Sets up one register of the batch's triangles, starting at triangle i.
///
/// rays  of the tile's samples
template <class D>
HWY_INLINE void set_up_lanes(D d, Batch& batch, int i, const LatticeTile& rays)
{
    using V = hn::Vec<D>;
    const hn::Rebind<float, D> f;
    const hn::Rebind<std::int32_t, D> w;
    const auto load = [&](int axis) {
        return hn::PromoteTo(d, hn::Load(f, batch.corner[axis] + i));
    };
    const auto whole = [&](const std::int32_t* p) { return hn::Load(w, p + i); };
    const auto real = [&](auto v) { return hn::PromoteTo(d, v); };
    const Vector3<V> v0{load(0), load(1), load(2)}, v1{load(3), load(4), load(5)},
        v2{load(6), load(7), load(8)};
    const Planes<V> p = planes_of(v0, v1, v2);

    const V ox = hn::Add(hn::Set(d, rays.x0), real(whole(batch.origin_x)));
    const V oy = hn::Add(hn::Set(d, rays.y0), real(whole(batch.origin_y)));
    const V extent_x = real(whole(batch.extent_x)), extent_y = real(whole(batch.extent_y));
    const V one = hn::Set(d, 1.0);
    const auto at_origin = [&](const Vector3<V>& n) {
        return hn::Add(hn::Add(hn::Mul(n.x, ox), hn::Mul(n.y, oy)), n.z);
    };

    // Compute depth, 1/t = n . d / volume, and whether its error in float, or at least in double,
    // is below kDepthError.
    const V inverse_volume = hn::Div(one, p.volume);
    const V wx = hn::Mul(p.n.x, inverse_volume), wy = hn::Mul(p.n.y, inverse_volume);
    const V wc = hn::Mul(at_origin(p.n), inverse_volume);
    const V farthest_z = hn::Max(v0.z, hn::Max(v1.z, v2.z));
    const V float_size = hn::Add(
        hn::Abs(wc), hn::Add(hn::Mul(extent_x, hn::Abs(wx)), hn::Mul(extent_y, hn::Abs(wy))));
    const V double_size = hn::Add(hn::Add(hn::Mul(p.n_size.x, hn::Add(hn::Abs(ox), extent_x)),
                                      hn::Mul(p.n_size.y, hn::Add(hn::Abs(oy), extent_y))),
        p.n_size.z);
    const auto float_fits = hn::Le(hn::Mul(float_size, farthest_z), hn::Set(d, 3.0));
    const auto well_conditioned = hn::And(
        hn::Ge(hn::Abs(p.volume), hn::Mul(hn::Set(d, 0x1p-24), p.volume_size)),
        hn::Le(hn::Mul(double_size, farthest_z), hn::Mul(hn::Set(d, 0x1p27), hn::Abs(p.volume))));
    // This is false for a volume of 0, which gives NaN.
    const auto double_fits =
        hn::And(well_conditioned, hn::Le(float_size, hn::Set(d, double(kGreatestW))));

    // Compute edges, positive inside, with |e| <= 1 over the extent.
    auto gx0 = hn::Zero(f), gy0 = gx0, c0 = gx0, gx1 = gx0, gy1 = gx0, c1 = gx0, gx2 = gx0,
         gy2 = gx0, c2 = gx0;
    const auto edge = [&](const Vector3<V>& n, auto& gx, auto& gy, auto& c) {
        const V at = at_origin(n);
        const V size = hn::Add(
            hn::Abs(at), hn::Add(hn::Mul(extent_x, hn::Abs(n.x)), hn::Mul(extent_y, hn::Abs(n.y))));
        const V scale = hn::Div(hn::CopySign(one, p.volume), size);
        gx = hn::DemoteTo(f, hn::Mul(n.x, scale));
        gy = hn::DemoteTo(f, hn::Mul(n.y, scale));
        c = hn::DemoteTo(f, hn::Mul(at, scale));
    };
    edge(p.edge[0], gx0, gy0, c0);
    edge(p.edge[1], gx1, gy1, c1);
    edge(p.edge[2], gx2, gy2, c2);

    // Choose the kernel. If an edge is negative over the whole box, the triangle misses the tile.
    const auto zero = hn::Zero(f);
    const auto bx0 = whole(batch.x0), by0 = whole(batch.y0);
    const auto bx1 = whole(batch.x1), by1 = whole(batch.y1);
    const auto start_x = hn::ConvertTo(f, hn::Sub(bx0, whole(batch.origin_x)));
    const auto start_y = hn::ConvertTo(f, hn::Sub(by0, whole(batch.origin_y)));
    const auto steps_x = hn::ConvertTo(f, hn::Sub(bx1, bx0));
    const auto steps_y = hn::ConvertTo(f, hn::Sub(by1, by0));
    const auto start = [&](auto gx, auto gy, auto c) {
        return hn::MulAdd(gx, start_x, hn::MulAdd(gy, start_y, c));
    };
    const auto s0 = start(gx0, gy0, c0), s1 = start(gx1, gy1, c1), s2 = start(gx2, gy2, c2);
    const auto most = [&](auto s, auto gx, auto gy) {
        return hn::MulAdd(hn::Max(gx, zero), steps_x, hn::MulAdd(hn::Max(gy, zero), steps_y, s));
    };
    const auto best = hn::Min(most(s0, gx0, gy0), hn::Min(most(s1, gx1, gy1), most(s2, gx2, gy2)));
    const auto missed = hn::Lt(best, hn::Set(f, -kBoxError));

    // Test the samples of tiny boxes, up to four, now.
    const auto wxf = hn::DemoteTo(f, wx), wyf = hn::DemoteTo(f, wy), wcf = hn::DemoteTo(f, wc);
    const auto sw = start(wxf, wyf, wcf);
    const auto single = hn::Set(f, 1.0f);
    auto tiny = hn::And(hn::Le(steps_x, single), hn::Le(steps_y, single));
    if (!hn::AllFalse(f, tiny)) {
        const auto sample = [&](int k, auto has) {
            const auto step = [&](auto s, auto gx, auto gy) {
                if (k & 1) s = hn::Add(s, gx);
                if (k & 2) s = hn::Add(s, gy);
                return s;
            };
            const auto m =
                hn::Min(step(s0, gx0, gy0), hn::Min(step(s1, gx1, gy1), step(s2, gx2, gy2)));
            const auto inside = hn::And(has, hn::Gt(m, hn::Set(f, kEdgeError)));
            const auto open = hn::AndNot(inside, hn::And(has, hn::Ge(m, hn::Set(f, -kEdgeError))));
            tiny = hn::AndNot(open, tiny);
            hn::Store(hn::IfThenElseZero(inside, step(sw, wxf, wyf)), f, batch.tiny_w[k] + i);
        };
        const auto right = hn::Gt(steps_x, zero), below = hn::Gt(steps_y, zero);
        sample(0, hn::Eq(zero, zero));
        sample(1, right);
        sample(2, below);
        sample(3, hn::And(right, below));
    }

    const auto is = [&](Kernel kernel) { return hn::Set(w, std::int32_t(kernel)); };
    const auto narrow = [&](auto mask) { // converts a mask of doubles to a mask of floats
        return hn::Ne(hn::DemoteTo(f, hn::IfThenElseZero(mask, one)), zero);
    };
    const auto large = hn::Ge(hn::Max(steps_x, steps_y), hn::Set(f, 16.0f));
    auto kernel = hn::IfThenElse(hn::RebindMask(w, large), is(Kernel::large), is(Kernel::small));
    kernel = hn::IfThenElse(hn::RebindMask(w, tiny), is(Kernel::tiny), kernel);
    kernel = hn::IfThenElse(hn::RebindMask(w, narrow(float_fits)), kernel, is(Kernel::wide));
    kernel = hn::IfThenElse(hn::RebindMask(w, missed), is(Kernel::none), kernel);
    kernel = hn::IfThenElse(hn::RebindMask(w, narrow(double_fits)), kernel, is(Kernel::exact));

    const auto store = [&](auto v, float* to) { hn::Store(v, f, to + i); };
    store(gx0, batch.gx[0]), store(gy0, batch.gy[0]), store(c0, batch.c[0]);
    store(gx1, batch.gx[1]), store(gy1, batch.gy[1]), store(c1, batch.c[1]);
    store(gx2, batch.gx[2]), store(gy2, batch.gy[2]), store(c2, batch.c[2]);
    store(wxf, batch.wx), store(wyf, batch.wy), store(wcf, batch.wc);
    hn::Store(wx, d, batch.wide_wx + i);
    hn::Store(wy, d, batch.wide_wy + i);
    hn::Store(wc, d, batch.wide_wc + i);
    hn::Store(kernel, w, reinterpret_cast<std::int32_t*>(batch.kernel) + i);
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif
