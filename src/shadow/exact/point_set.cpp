// point_set.cpp - sorts points along a z-order curve and moves them into a light's space.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow/exact/point_set.cpp"
#include "base/simd.h"

#include "shadow/exact/point_set.h"
#include "shadow/exact/to_light-inl.h"

#include <algorithm>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

void move(const PointSet& set, const PencilSpace& space, std::size_t first, PointChunk& chunk)
{
    const hn::RebindToUnsigned<RealTag> du;
    for (std::size_t k = 0; k < chunk.count; k += std::size_t(kLanes)) {
        const real3 p(load(set.x.data() + first + k), load(set.y.data() + first + k),
            load(set.z.data() + first + k));
        const real3 d = to_light(space, p);
        store(d.x, chunk.x.data() + k);
        store(d.y, chunk.y.data() + k);
        store(d.z, chunk.z.data() + k);
        hn::Store(hn::Load(du, set.number.data() + first + k), du, chunk.id.data() + k);
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(move);

namespace {

constexpr int kAxisBits = 10;
constexpr std::size_t kGrain = 16384;

/// Inserts two zero bits between each two of the ten lowest bits.
std::uint64_t spread_bits(std::uint64_t v)
{
    v = (v | v << 16) & 0x030000FF;
    v = (v | v << 8) & 0x0300F00F;
    v = (v | v << 4) & 0x030C30C3;
    v = (v | v << 2) & 0x09249249;
    return v;
}

/// Maps points in the bounding box to keys along the z-order curve. A NaN coordinate counts as the
/// lowest.
struct Curve {
    glm::vec3 low{std::numeric_limits<float>::infinity()};
    glm::vec3 scale{0};

    explicit Curve(std::span<const glm::vec3> points)
    {
        glm::vec3 high = -low;
        for (const glm::vec3& p : points) {
            if (!usable(p)) continue;
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        for (int axis = 0; axis < 3; ++axis) {
            const float length = high[axis] - low[axis];
            if (length > 0) scale[axis] = float((1 << kAxisBits) - 1) / length;
        }
    }

    std::uint64_t key_of(const glm::vec3& p) const
    {
        std::uint64_t key = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const float step = (p[axis] - low[axis]) * scale[axis];
            const float kept = step > 0 ? std::min(step, float((1 << kAxisBits) - 1)) : 0;
            key |= spread_bits(std::uint64_t(kept)) << axis;
        }
        return key;
    }
};

/// Radix sort by the upper 32 bits, ten bits a pass.
void sort_keys(Buffer<std::uint64_t>& keys, Buffer<std::uint64_t>& spare)
{
    constexpr int kDigit = 10;
    for (int shift = 32; shift < 32 + 3 * kAxisBits; shift += kDigit) {
        std::uint32_t start[(1 << kDigit) + 1] = {};
        const auto digit = [&](std::uint64_t key) { return key >> shift & ((1 << kDigit) - 1); };
        for (const std::uint64_t key : keys.span()) ++start[digit(key) + 1];
        for (int k = 0; k < 1 << kDigit; ++k) start[k + 1] += start[k];
        for (const std::uint64_t key : keys.span()) spare[start[digit(key)]++] = key;
        std::swap(keys, spare);
    }
}

} // namespace

void make_point_set(std::span<const glm::vec3> points, std::span<const std::uint32_t> receivers,
    bool ordered, PointSet& set, Tasks& tasks)
{
    set.given = points;
    set.receivers = receivers;
    for (auto* values : {&set.x, &set.y, &set.z}) values->resize(points.size());
    set.number.resize(points.size());
    if (ordered) {
        const Curve curve(points);
        set.key.resize(points.size());
        set.spare.resize(points.size());
        tasks.for_ranges(points.size(), kGrain, [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last; ++k)
                set.key[k] = curve.key_of(points[k]) << 32 | k;
        });
        sort_keys(set.key, set.spare);
    }
    tasks.for_ranges(points.size(), kGrain, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) {
            const std::uint32_t number = ordered ? std::uint32_t(set.key[k]) : std::uint32_t(k);
            const glm::vec3& p = points[number];
            set.number[k] = number;
            set.x[k] = p.x, set.y[k] = p.y, set.z[k] = p.z;
        }
    });
}

void move_points(
    const PointSet& set, const PencilSpace& space, std::size_t first, PointChunk& chunk)
{
    HWY_DYNAMIC_DISPATCH(move)(set, space, first, chunk);
}

} // namespace firsthit
#endif
