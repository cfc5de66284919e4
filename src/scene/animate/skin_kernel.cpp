// skin_kernel.cpp - skins by the matrices of joints, 4 to 16 vertices at a time (Highway).
//
// A vertex's matrix is blended first, column by column; a group of vertices as wide as a register then
// lies in a buffer on the stack, from where it is transposed: a register has one number of all of them.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scene/animate/skin_kernel.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "scene/animate/skin_kernel.h"

#include <algorithm>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t kMaxLanes = 16;
using Floats = hn::CappedTag<float, kMaxLanes>;
using Float = hn::Vec<Floats>;

/// The blended matrices of as many vertices as a register has lanes: (4 columns, lanes, 4 rows).
struct alignas(64) Blended {
    float column[4][4 * kMaxLanes];
};

/// influences  of each vertex, or kAny: then skin.influences
constexpr int kAny = 0;
/// Stores numbers [first, first + lanes) of a vertex's 16.
template <class D>
HWY_INLINE void store_columns(
    D d, hn::Vec<D> numbers, std::size_t first, std::size_t vertex, Blended& blended)
{
#if HWY_TARGET != HWY_SCALAR
    if constexpr (hn::MaxLanes(d) > 4) {
        const hn::Half<D> half;
        store_columns(half, hn::LowerHalf(half, numbers), first, vertex, blended);
        store_columns(
            half, hn::UpperHalf(half, numbers), first + hn::MaxLanes(half), vertex, blended);
        return;
    }
#endif
    hn::StoreU(numbers, d, blended.column[first / 4] + 4 * vertex + first % 4);
}

template <int kInfluences>
HWY_INLINE void blend(
    const SkinnedVertices& skin, std::size_t first, std::size_t count, Blended& blended)
{
    const Floats d;
    const auto influences =
        static_cast<std::size_t>(kInfluences == kAny ? skin.influences : kInfluences);
    const std::uint16_t* joint = skin.joint + first * influences;
    const float* weight = skin.weight + first * influences;
    for (std::size_t v = 0; v < count; ++v, joint += influences, weight += influences)
        for (std::size_t number = 0; number < 16; number += hn::MaxLanes(d)) {
            const float* matrices = skin.joint_matrix + number;
            Float sum =
                hn::Mul(hn::Set(d, weight[0]), hn::LoadU(d, matrices + 16 * std::size_t(joint[0])));
            for (std::size_t k = 1; k < influences; ++k)
                sum = hn::Add(sum, hn::Mul(hn::Set(d, weight[k]),
                                       hn::LoadU(d, matrices + 16 * std::size_t(joint[k]))));
            store_columns(d, sum, number, v, blended);
        }
}

struct Vectors {
    Float x, y, z;
};

HWY_INLINE Vectors column_of(const Blended& blended, int column)
{
    Vectors v;
    Float unused;
    hn::LoadInterleaved4(Floats(), blended.column[column], v.x, v.y, v.z, unused);
    return v;
}

HWY_INLINE Float dot(const Vectors& a, const Vectors& b)
{
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

HWY_INLINE Vectors cross(const Vectors& a, const Vectors& b)
{
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)),
        hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
        hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

/// a x + b y + c z.
HWY_INLINE Vectors combine(const Vectors& a, const Vectors& b, const Vectors& c, const Vectors& at)
{
    const auto sum = [&](Float p, Float q, Float r) {
        return hn::Add(hn::Add(hn::Mul(p, at.x), hn::Mul(q, at.y)), hn::Mul(r, at.z));
    };
    return {sum(a.x, b.x, c.x), sum(a.y, b.y, c.y), sum(a.z, b.z, c.z)};
}

/// Unit, or `other` where there is no direction.
HWY_INLINE Vectors unit_or(const Vectors& v, Float other_x, Float other_z)
{
    const Floats d;
    // Scaled by its largest component first: cofactors of small or large matrices have squares that
    // a float does not hold.
    const Float largest = hn::Max(hn::Max(hn::Abs(v.x), hn::Abs(v.y)), hn::Abs(v.z));
    const auto good = hn::And(hn::Gt(largest, hn::Set(d, 1e-37f)),
        hn::Le(largest, hn::Set(d, std::numeric_limits<float>::max())));
    const Float scale = hn::Div(hn::Set(d, 1.0f), hn::IfThenElse(good, largest, hn::Set(d, 1.0f)));
    const Vectors s{hn::Mul(v.x, scale), hn::Mul(v.y, scale), hn::Mul(v.z, scale)};
    const Float inv_length = hn::Div(hn::Set(d, 1.0f), hn::Sqrt(dot(s, s)));
    return {hn::IfThenElse(good, hn::Mul(s.x, inv_length), other_x),
        hn::IfThenElseZero(good, hn::Mul(s.y, inv_length)),
        hn::IfThenElse(good, hn::Mul(s.z, inv_length), other_z)};
}

/// Vertices as numbers, (V, 3).
struct FloatVertices {
    const float* position;
    const float* normal;

    FloatVertices from(std::size_t vertex) const
    {
        return {position + 3 * vertex, normal + 3 * vertex};
    }
};

/// Where moved vertices go, as numbers, (V, 3).
struct MovedFloats {
    float* position;
    float* normal;

    MovedFloats from(std::size_t vertex) const
    {
        return {position + 3 * vertex, normal + 3 * vertex};
    }
};

/// returns  zero in each lane whose position is finite, otherwise not a number
HWY_INLINE Float move_group(
    const Blended& blended, const FloatVertices& from, const MovedFloats& to)
{
    const Floats d;
    const Vectors c0 = column_of(blended, 0), c1 = column_of(blended, 1);
    const Vectors c2 = column_of(blended, 2), c3 = column_of(blended, 3);
    Vectors p, n;
    hn::LoadInterleaved3(d, from.position, p.x, p.y, p.z);
    hn::LoadInterleaved3(d, from.normal, n.x, n.y, n.z);
    Vectors w = combine(c0, c1, c2, p);
    w = {hn::Add(w.x, c3.x), hn::Add(w.y, c3.y), hn::Add(w.z, c3.z)};
    hn::StoreInterleaved3(w.x, w.y, w.z, d, to.position);

    // The cofactors are the inverse transpose times the determinant, whose sign alone matters.
    const Vectors a = cross(c1, c2);
    Vectors m = combine(a, cross(c2, c0), cross(c0, c1), n);
    const Float determinant = dot(c0, a);
    const auto mirrors = hn::Lt(determinant, hn::Zero(d));
    m = {hn::IfThenElse(mirrors, hn::Neg(m.x), m.x), hn::IfThenElse(mirrors, hn::Neg(m.y), m.y),
        hn::IfThenElse(mirrors, hn::Neg(m.z), m.z)};
    m = unit_or(m, hn::Zero(d), hn::Set(d, 1.0f));
    hn::StoreInterleaved3(m.x, m.y, m.z, d, to.normal);
    return hn::Add(hn::Add(hn::Sub(w.x, w.x), hn::Sub(w.y, w.y)), hn::Sub(w.z, w.z));
}

template <int kInfluences>
bool skin_with(const SkinnedVertices& skin, std::size_t count, const FloatVertices& from,
    const MovedFloats& to)
{
    const Floats d;
    constexpr std::size_t lanes = hn::MaxLanes(d);
    Blended blended = {};
    Float bad = hn::Zero(d);
    std::size_t k = 0;
    for (; k + lanes <= count; k += lanes) {
        blend<kInfluences>(skin, k, lanes, blended);
        bad = hn::Add(bad, move_group(blended, from.from(k), to.from(k)));
    }
    if (k < count) {
        // The rest goes through buffers whose unused lanes are finite.
        const std::size_t rest = 3 * (count - k);
        float p[3 * kMaxLanes] = {};
        float n[3 * kMaxLanes] = {};
        std::copy_n(from.position + 3 * k, rest, p);
        std::copy_n(from.normal + 3 * k, rest, n);
        blended = {};
        blend<kInfluences>(skin, k, count - k, blended);
        bad = hn::Add(bad, move_group(blended, {p, n}, {p, n}));
        std::copy_n(p, rest, to.position + 3 * k);
        std::copy_n(n, rest, to.normal + 3 * k);
    }
    return hn::AllTrue(d, hn::Eq(bad, hn::Zero(d)));
}

bool skin_vertices(const SkinnedVertices& skin, std::size_t count, const ObjectVertices& from,
    const MovedVertices& to)
{
    const FloatVertices numbers{&from.position->x, &from.normal->x};
    const MovedFloats moved{&to.position->x, &to.normal->x};
    if (skin.influences == 4) return skin_with<4>(skin, count, numbers, moved);
    return skin_with<kAny>(skin, count, numbers, moved);
}

void skin_tangents(
    const SkinnedVertices& skin, std::size_t count, const float* tangent, float* moved_tangent)
{
    const Floats d;
    constexpr std::size_t lanes = hn::MaxLanes(d);
    for (std::size_t k = 0; k < count; k += lanes) {
        const std::size_t used = std::min(lanes, count - k);
        Blended blended = {};
        blend<kAny>(skin, k, used, blended);
        alignas(64) float t[4 * kMaxLanes] = {};
        std::copy_n(tangent + 4 * k, 4 * used, t);
        Vectors v;
        Float w;
        hn::LoadInterleaved4(d, t, v.x, v.y, v.z, w);
        const Vectors c0 = column_of(blended, 0), c1 = column_of(blended, 1);
        const Vectors c2 = column_of(blended, 2);
        v = unit_or(combine(c0, c1, c2, v), hn::Set(d, 1.0f), hn::Zero(d));
        const auto mirrors = hn::Lt(dot(c0, cross(c1, c2)), hn::Zero(d));
        hn::StoreInterleaved4(v.x, v.y, v.z, hn::IfThenElse(mirrors, hn::Neg(w), w), d, t);
        std::copy_n(t, 4 * used, moved_tangent + 4 * k);
    }
}

void add_weighted(float weight, const float* term, std::size_t count, float* sum)
{
    const Floats d;
    constexpr std::size_t lanes = hn::MaxLanes(d);
    const Float w = hn::Set(d, weight);
    std::size_t k = 0;
    for (; k + lanes <= count; k += lanes)
        hn::StoreU(hn::Add(hn::LoadU(d, sum + k), hn::Mul(w, hn::LoadU(d, term + k))), d, sum + k);
    for (; k < count; ++k) {
        const float product = weight * term[k];
        sum[k] = sum[k] + product;
    }
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(skin_vertices);
HWY_EXPORT(skin_tangents);
HWY_EXPORT(add_weighted);

static_assert(sizeof(glm::vec3) == 3 * sizeof(float) && sizeof(glm::vec4) == 4 * sizeof(float));

bool skin_vertices(const SkinnedVertices& skin, std::size_t count, const ObjectVertices& from,
    const MovedVertices& to)
{
    if (count == 0) return true; // the arrays may be null
    return HWY_DYNAMIC_DISPATCH(skin_vertices)(skin, count, from, to);
}

void skin_tangents(const SkinnedVertices& skin, std::size_t count, const glm::vec4* tangent,
    glm::vec4* moved_tangent)
{
    if (count == 0) return;
    HWY_DYNAMIC_DISPATCH(skin_tangents)(skin, count, &tangent->x, &moved_tangent->x);
}

void add_weighted(float weight, const float* term, std::size_t count, float* sum)
{
    if (count == 0) return;
    HWY_DYNAMIC_DISPATCH(add_weighted)(weight, term, count, sum);
}

} // namespace firsthit
#endif // HWY_ONCE
