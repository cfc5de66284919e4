// project.cpp - vertices into eye space, once each.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "visibility/project.cpp"
#include "base/simd.h"

#include "exact/hit.h"
#include "visibility/project.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Wide = hn::ScalableTag<double>;
using Narrow = hn::Rebind<float, Wide>;
using Whole = hn::Rebind<std::int32_t, Wide>;

/// Boxes are this much wider than the double projection: 2^18 times its error at 16384 samples.
constexpr double kMargin = 0x1p-12;

/// The first sample at or after s and minus the last at or before it, both clamped to [0, count).
template <class V>
void sample_range(V s, int count, V& first, V& minus_last)
{
    const Wide d;
    const V margin = hn::Set(d, kMargin);
    first = hn::Ceil(hn::Sub(s, margin));
    first = hn::Min(hn::Max(first, hn::Zero(d)), hn::Set(d, count));
    minus_last = hn::Ceil(hn::Sub(hn::Neg(s), margin)); // -floor(s + margin)
    minus_last = hn::Min(hn::Max(minus_last, hn::Set(d, 1 - count)), hn::Set(d, 1));
}

/// One register of vertices.
void project(const float* HWY_RESTRICT xyz, const Pencil& pencil, float* HWY_RESTRICT corner,
    std::int32_t* HWY_RESTRICT box)
{
    const Wide d;
    const Narrow f;
    const Whole w;
    auto xf = hn::Zero(f), yf = xf, zf = xf;
    hn::LoadInterleaved3(f, xyz, xf, yf, zf);
    const auto px = hn::Sub(hn::PromoteTo(d, xf), hn::Set(d, pencil.eye.x));
    const auto py = hn::Sub(hn::PromoteTo(d, yf), hn::Set(d, pencil.eye.y));
    const auto pz = hn::Sub(hn::PromoteTo(d, zf), hn::Set(d, pencil.eye.z));
    const auto row = [&](int r) {
        const glm::dmat3& m = pencil.eye_from_world;
        const auto xy = hn::Add(hn::Mul(hn::Set(d, m[0][r]), px), hn::Mul(hn::Set(d, m[1][r]), py));
        return hn::Add(xy, hn::Mul(hn::Set(d, m[2][r]), pz));
    };
    auto eye_x = row(0), eye_y = row(1), eye_z = row(2);
    if (pencil.parallel) {
        eye_z = hn::Div(hn::Set(d, 1.0), hn::Sub(hn::Set(d, pencil.far), eye_z));
        eye_x = hn::Mul(eye_x, eye_z);
        eye_y = hn::Mul(eye_y, eye_z);
    }
    const auto x = hn::DemoteTo(f, eye_x), y = hn::DemoteTo(f, eye_y), z = hn::DemoteTo(f, eye_z);
    hn::StoreInterleaved4(x, y, z, hn::Zero(f), f, corner);

    // Where the vertex stands among the samples. NaN and infinity take the careful way.
    const auto limit = hn::Set(f, kFarthest);
    const auto finite = hn::And(
        hn::Lt(hn::Abs(x), limit), hn::And(hn::Lt(hn::Abs(y), limit), hn::Lt(hn::Abs(z), limit)));
    const auto in_front = hn::And(finite, hn::Gt(z, hn::Zero(f)));
    const auto zd = hn::PromoteTo(d, hn::IfThenElse(in_front, z, hn::Set(f, 1.0f)));
    const auto xd = hn::PromoteTo(d, hn::IfThenElseZero(in_front, x));
    const auto yd = hn::PromoteTo(d, hn::IfThenElseZero(in_front, y));
    auto first_x = zd, first_y = zd, minus_last_x = zd, minus_last_y = zd;
    sample_range(
        hn::Sub(hn::Div(xd, zd), hn::Set(d, pencil.x0)), pencil.width, first_x, minus_last_x);
    sample_range(
        hn::Sub(hn::Div(yd, zd), hn::Set(d, pencil.y0)), pencil.height, first_y, minus_last_y);

    const auto whole = [&](auto v) { return hn::DemoteTo(w, v); };
    const auto pair = [&](auto low, auto high) {
        return hn::Or(hn::And(low, hn::Set(w, 0xFFFF)), hn::ShiftLeft<16>(high));
    };
    const auto front = hn::RebindMask(w, in_front);
    const auto first =
        pair(hn::IfThenElse(front, whole(first_x), hn::Set(w, VertexBox::kBehind)), whole(first_y));
    hn::StoreInterleaved2(first, pair(whole(minus_last_x), whole(minus_last_y)), w, box);
}

void project_range(
    const glm::vec3* position, std::size_t first, std::size_t last, ViewMemory& memory)
{
    const std::size_t lanes = hn::Lanes(Wide());
    for (std::size_t v = first; v < last; v += lanes) {
        float* corner = &memory.corner[v].x;
        auto* box = reinterpret_cast<std::int32_t*>(&memory.box[v]);
        if (v + lanes <= last) {
            project(&position[v].x, memory.pencil, corner, box);
        } else {
            float rest[3 * 64] = {};
            std::copy_n(&position[v].x, 3 * (last - v), rest);
            project(rest, memory.pencil, corner, box); // the buffers have room for a register
        }
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(project_range);

void project_vertices(std::span<const glm::vec3> position, ViewMemory& memory, Tasks& tasks)
{
    constexpr std::size_t kPadding = 64;
    // Ranges of whole registers, so that no two threads write the same register's padding.
    constexpr std::size_t kGrain = 4096;
    memory.corner.resize(position.size() + kPadding);
    memory.box.resize(position.size() + kPadding);
    tasks.for_ranges(position.size(), kGrain, [&](std::size_t first, std::size_t last) {
        HWY_DYNAMIC_DISPATCH(project_range)(position.data(), first, last, memory);
    });
}

} // namespace firsthit
#endif
