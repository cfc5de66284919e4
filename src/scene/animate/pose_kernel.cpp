// pose_kernel.cpp - moves many vertices by one matrix, 4 to 16 at a time (Highway).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scene/animate/pose_kernel.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "scene/animate/pose_kernel.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// No more lanes than this, so that a part's last vertices fit a buffer on the stack.
constexpr std::size_t kMaxLanes = 16;
using Floats = hn::CappedTag<float, kMaxLanes>;
using Float = hn::Vec<Floats>;

/// Multiplications and additions apart, in one order: fused ones would differ between machines.
HWY_INLINE Float row_times(const float* row, Float x, Float y, Float z)
{
    const Floats d;
    return hn::Add(hn::Add(hn::Mul(hn::Set(d, row[0]), x), hn::Mul(hn::Set(d, row[1]), y)),
        hn::Mul(hn::Set(d, row[2]), z));
}

/// returns  zero in each lane whose position is finite, otherwise not a number
HWY_INLINE Float move_points(const VertexMatrix& m, const float* from, float* to)
{
    const Floats d;
    Float x, y, z;
    hn::LoadInterleaved3(d, from, x, y, z);
    const Float wx = hn::Add(row_times(m.point, x, y, z), hn::Set(d, m.point[3]));
    const Float wy = hn::Add(row_times(m.point + 4, x, y, z), hn::Set(d, m.point[7]));
    const Float wz = hn::Add(row_times(m.point + 8, x, y, z), hn::Set(d, m.point[11]));
    hn::StoreInterleaved3(wx, wy, wz, d, to);
    return hn::Add(hn::Add(hn::Sub(wx, wx), hn::Sub(wy, wy)), hn::Sub(wz, wz));
}

HWY_INLINE void move_normals(const VertexMatrix& m, const float* from, float* to)
{
    const Floats d;
    Float x, y, z;
    hn::LoadInterleaved3(d, from, x, y, z);
    const Float wx = row_times(m.normal, x, y, z);
    const Float wy = row_times(m.normal + 3, x, y, z);
    const Float wz = row_times(m.normal + 6, x, y, z);
    const Float square = hn::Add(hn::Add(hn::Mul(wx, wx), hn::Mul(wy, wy)), hn::Mul(wz, wz));
    const Float scale = hn::Div(hn::Set(d, 1.0f), hn::Sqrt(square));
    // The matrix and the normals are about 1: this is far below all that has a direction.
    const auto good = hn::And(hn::Ge(square, hn::Set(d, 1e-30f)),
        hn::Le(square, hn::Set(d, std::numeric_limits<float>::max())));
    hn::StoreInterleaved3(hn::IfThenElseZero(good, hn::Mul(wx, scale)),
        hn::IfThenElseZero(good, hn::Mul(wy, scale)),
        hn::IfThenElse(good, hn::Mul(wz, scale), hn::Set(d, 1.0f)), d, to);
}

bool move_vertices(
    const VertexMatrix& m, std::size_t count, const ObjectVertices& from, const MovedVertices& to)
{
    const float* const position = &from.position->x;
    const float* const normal = &from.normal->x;
    float* const moved_position = &to.position->x;
    float* const moved_normal = &to.normal->x;
    const Floats d;
    const std::size_t lanes = hn::Lanes(d);
    Float bad = hn::Zero(d);
    std::size_t k = 0;
    for (; k + lanes <= count; k += lanes) {
        bad = hn::Add(bad, move_points(m, position + 3 * k, moved_position + 3 * k));
        move_normals(m, normal + 3 * k, moved_normal + 3 * k);
    }
    if (k < count) {
        // The rest goes through a buffer whose unused lanes are zero.
        const std::size_t rest = 3 * (count - k);
        float p[3 * kMaxLanes] = {};
        float n[3 * kMaxLanes] = {};
        std::copy_n(position + 3 * k, rest, p);
        std::copy_n(normal + 3 * k, rest, n);
        bad = hn::Add(bad, move_points(m, p, p));
        move_normals(m, n, n);
        std::copy_n(p, rest, moved_position + 3 * k);
        std::copy_n(n, rest, moved_normal + 3 * k);
    }
    return hn::AllTrue(d, hn::Eq(bad, hn::Zero(d)));
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(move_vertices);

static_assert(sizeof(glm::vec3) == 3 * sizeof(float));

VertexMatrix vertex_matrix(const glm::dmat4& world_from_object)
{
    VertexMatrix matrix;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            matrix.point[4 * row + column] = static_cast<float>(world_from_object[column][row]);

    // The cofactors are the inverse transpose times the determinant, whose sign alone matters.
    const glm::dmat3 m(world_from_object);
    glm::dmat3 cofactor(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    double largest = 0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            largest = std::max(largest, std::abs(cofactor[column][row]));
    const double sign = glm::dot(m[0], cofactor[0]) < 0 ? -1.0 : 1.0;
    const double scale = largest > 0 ? sign / largest : 0.0;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            matrix.normal[3 * row + column] = static_cast<float>(cofactor[column][row] * scale);
    return matrix;
}

bool move_vertices(const VertexMatrix& matrix, std::size_t count, const ObjectVertices& from,
    const MovedVertices& to)
{
    if (count == 0) return true; // the arrays may be null
    return HWY_DYNAMIC_DISPATCH(move_vertices)(matrix, count, from, to);
}

} // namespace firsthit
#endif // HWY_ONCE
