// to_light-inl.h - moves points into a light's space, a register at a time.
#if defined(FIRSTHIT_SHADOW_EXACT_TO_LIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SHADOW_EXACT_TO_LIGHT_INL_H_
#undef FIRSTHIT_SHADOW_EXACT_TO_LIGHT_INL_H_
#else
#define FIRSTHIT_SHADOW_EXACT_TO_LIGHT_INL_H_
#endif

#include "base/simd_real-inl.h"
#include "exact/shadow_ray.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// Vector version of to_light() (exact/shadow_ray.h), with the same bits.
HWY_INLINE real3 to_light(const PencilSpace& space, real3 p)
{
    if (!space.directional) return p - real3(space.origin.x, space.origin.y, space.origin.z);
    const hn::CappedTag<double, 8> d;
    const hn::Rebind<float, decltype(d)> f;
    alignas(64) float x[kLanes], y[kLanes], z[kLanes];
    store(p.x, x), store(p.y, y), store(p.z, z);
    for (int k = 0; k < kLanes; k += int(hn::Lanes(d))) {
        const auto wide = [&](const float* v) { return hn::PromoteTo(d, hn::Load(f, v + k)); };
        const auto px = wide(x), py = wide(y), pz = wide(z);
        const auto row = [&](int r) {
            const auto xy = hn::Add(hn::Mul(hn::Set(d, space.axes[0][r]), px),
                hn::Mul(hn::Set(d, space.axes[1][r]), py));
            return hn::Add(xy, hn::Mul(hn::Set(d, space.axes[2][r]), pz));
        };
        auto qx = row(0), qy = row(1), qz = row(2);
        if (space.distance > 0) {
            const auto distance = hn::Set(d, space.distance);
            const auto share = hn::Div(distance, hn::Add(distance, qz));
            qx = hn::Mul(qx, share), qy = hn::Mul(qy, share), qz = hn::Mul(qz, share);
        }
        const auto keep = [&](auto q, float* to) { hn::Store(hn::DemoteTo(f, q), f, to + k); };
        keep(qx, x), keep(qy, y), keep(qz, z);
    }
    return real3(load(x), load(y), load(z));
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
