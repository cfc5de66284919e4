// triangle_planes-inl.h - the planes of a triangle, and those through the eye and its edges, in
// double.
#if defined(FIRSTHIT_TRIANGLE_PLANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_TRIANGLE_PLANES_INL_H
#undef FIRSTHIT_TRIANGLE_PLANES_INL_H
#else
#define FIRSTHIT_TRIANGLE_PLANES_INL_H
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// An edge function that is at most 1 inside a box, evaluated in float at a sample of the box, has
/// at most this error (proof in set_up-inl.h).
constexpr float kEdgeError = 6 * 0x1p-24f;

template <class V>
struct Vector3 {
    V x, y, z;
};

template <class V>
HWY_INLINE Vector3<V> cross(const Vector3<V>& a, const Vector3<V>& b)
{
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)),
        hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
        hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

/// |a.y b.z| + |a.z b.y|, ...: the rounding error of cross(a, b) is at most a few roundings of
/// this.
template <class V>
HWY_INLINE Vector3<V> cross_size(const Vector3<V>& a, const Vector3<V>& b)
{
    const auto term = [](V p, V q, V r, V s) {
        return hn::Add(hn::Abs(hn::Mul(p, q)), hn::Abs(hn::Mul(r, s)));
    };
    return {term(a.y, b.z, a.z, b.y), term(a.z, b.x, a.x, b.z), term(a.x, b.y, a.y, b.x)};
}

template <class V>
HWY_INLINE Vector3<V> sub(const Vector3<V>& a, const Vector3<V>& b)
{
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

/// The plane of a triangle, and the planes through the origin and each edge.
template <class V>
struct Planes {
    Vector3<V> edge[3];    // v1 x v2, v2 x v0, v0 x v1: edge k is opposite of corner k
    Vector3<V> n;          // (v1 - v0) x (v2 - v0)
    Vector3<V> n_size;     // bounds the error of n, see cross_size
    V volume, volume_size; // v0 . edge[0], and the sum of its terms' absolute values
};

template <class V>
HWY_INLINE Planes<V> planes_of(const Vector3<V>& v0, const Vector3<V>& v1, const Vector3<V>& v2)
{
    Planes<V> p;
    p.edge[0] = cross(v1, v2);
    p.edge[1] = cross(v2, v0);
    p.edge[2] = cross(v0, v1);
    const auto e1 = sub(v1, v0), e2 = sub(v2, v0);
    p.n = cross(e1, e2);
    p.n_size = cross_size(e1, e2);
    const V tx = hn::Mul(v0.x, p.edge[0].x), ty = hn::Mul(v0.y, p.edge[0].y),
            tz = hn::Mul(v0.z, p.edge[0].z);
    p.volume = hn::Add(hn::Add(tx, ty), tz);
    p.volume_size = hn::Add(hn::Add(hn::Abs(tx), hn::Abs(ty)), hn::Abs(tz));
    return p;
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif
