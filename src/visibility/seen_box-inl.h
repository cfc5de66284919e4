// seen_box-inl.h - the box of a triangle as a light's face sees it.
#if defined(FIRSTHIT_VISIBILITY_SEEN_BOX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_VISIBILITY_SEEN_BOX_INL_H_
#undef FIRSTHIT_VISIBILITY_SEEN_BOX_INL_H_
#else
#define FIRSTHIT_VISIBILITY_SEEN_BOX_INL_H_
#endif

#include <hwy/highway.h>

#include "visibility/light_mesh.h"

#include <algorithm>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The least and greatest x, y and w of a triangle's corners.
struct SeenBox {
    alignas(16) float low[4];
    alignas(16) float high[4];
    std::uint32_t triangle;

    float nearest_w() const { return high[2]; }
};

/// Of a triangle all of whose corners are seen. Four floats are read at each.
HWY_INLINE SeenBox seen_box(const LightMesh& mesh, std::uint32_t triangle)
{
    const glm::uvec3& index = mesh.index[triangle];
    const SeenPoint &a = mesh.seen[index.x], &b = mesh.seen[index.y], &c = mesh.seen[index.z];
    SeenBox box;
    box.triangle = triangle;
#if HWY_TARGET == HWY_SCALAR
    const float corner[3][3] = {{a.x, a.y, a.w}, {b.x, b.y, b.w}, {c.x, c.y, c.w}};
    for (int k = 0; k < 3; ++k) {
        box.low[k] = std::min({corner[0][k], corner[1][k], corner[2][k]});
        box.high[k] = std::max({corner[0][k], corner[1][k], corner[2][k]});
    }
#else
    const hn::FixedTag<float, 4> d;
    const auto p = hn::LoadU(d, &a.x), q = hn::LoadU(d, &b.x), r = hn::LoadU(d, &c.x);
    hn::Store(hn::Min(hn::Min(p, q), r), d, box.low);
    hn::Store(hn::Max(hn::Max(p, q), r), d, box.high);
#endif
    return box;
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
