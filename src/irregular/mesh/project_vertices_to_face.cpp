// project_vertices_to_face.cpp - moves vertices into a pencil's space, and projects them to a face.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "irregular/mesh/project_vertices_to_face.cpp"
#include "base/simd.h"

#include "irregular/mesh/pencil_mesh.h"
#include "irregular/mesh/project_lanes_to_face-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Reals = hn::CappedTag<float, 16>;

void project_register(const CubeFace& face, const float* corner, float* projected)
{
    const Reals d;
    auto px = hn::Zero(d), py = px, pz = px;
    hn::LoadInterleaved3(d, corner, px, py, pz);
    const ProjectedLanes<Reals> v = project_lanes_to_face(d, face, px, py, pz);
    hn::StoreInterleaved3(hn::IfThenElse(v.valid, v.x, hn::NaN(d)), v.y, v.w, d, projected);
}

void project(
    const CubeFace& face, const glm::vec3* corner, std::size_t count, ProjectedPoint* projected)
{
    const std::size_t lanes = hn::Lanes(Reals());
    std::size_t v = 0;
    for (; v + lanes <= count; v += lanes) project_register(face, &corner[v].x, &projected[v].x);
    if (v == count) return;
    float from[3 * 16] = {}, to[3 * 16];
    std::copy_n(&corner[v].x, 3 * (count - v), from);
    project_register(face, from, to);
    std::copy_n(to, 3 * (count - v), &projected[v].x);
}

VertexBox subtract_origin(
    const glm::vec3& origin, const glm::vec3* position, std::size_t count, glm::vec3* corner)
{
    const Reals d;
    const std::size_t lanes = hn::Lanes(d);
    const auto far = hn::Inf(d), near = hn::Neg(far);
    auto x0 = far, y0 = far, z0 = far, x1 = near, y1 = near, z1 = near;
    const auto move_register = [&](const float* from, float* to) {
        auto x = hn::Zero(d), y = x, z = x;
        hn::LoadInterleaved3(d, from, x, y, z);
        x = hn::Sub(x, hn::Set(d, origin.x));
        y = hn::Sub(y, hn::Set(d, origin.y));
        z = hn::Sub(z, hn::Set(d, origin.z));
        x0 = hn::Min(x, x0), y0 = hn::Min(y, y0), z0 = hn::Min(z, z0);
        x1 = hn::Max(x, x1), y1 = hn::Max(y, y1), z1 = hn::Max(z, z1);
        hn::StoreInterleaved3(x, y, z, d, to);
    };
    std::size_t v = 0;
    for (; v + lanes <= count; v += lanes) move_register(&position[v].x, &corner[v].x);
    if (v < count) {
        glm::vec3 last[16], moved[16];
        for (std::size_t k = 0; k < lanes; ++k) last[k] = position[std::min(v + k, count - 1)];
        move_register(&last[0].x, &moved[0].x);
        std::copy_n(moved, count - v, corner + v);
    }
    const auto least = [&](auto value) { return hn::GetLane(hn::MinOfLanes(d, value)); };
    const auto most = [&](auto value) { return hn::GetLane(hn::MaxOfLanes(d, value)); };
    return {{least(x0), least(y0), least(z0)}, {most(x1), most(y1), most(z1)}};
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(project);
HWY_EXPORT(subtract_origin);

VertexBox move_to_pencil_space(
    const PencilSpace& space, const glm::vec3* position, std::size_t count, glm::vec3* corner)
{
    if (!space.directional)
        return HWY_DYNAMIC_DISPATCH(subtract_origin)(space.origin, position, count, corner);
    for (std::size_t v = 0; v < count; ++v) corner[v] = to_light(space, position[v]);
    return {};
}

void project_vertices_to_face(
    const CubeFace& face, const glm::vec3* corner, std::size_t count, ProjectedPoint* projected)
{
    HWY_DYNAMIC_DISPATCH(project)(face, corner, count, projected);
}

} // namespace firsthit
#endif
