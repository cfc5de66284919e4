// occlusion.cpp - finds the points that a light does not reach.
#include "base/instruction_set.h"
#include "base/tasks.h"
#include "exact/shadow_ray.h"
#include "hits/spot_cone.h"
#include "render/check_occlusion.h"
#include "shadow/exact/point_shadows.h"

#include <firsthit/occlusion.h>

#include <algorithm>

namespace firsthit {

struct Occlusion::Impl {
    explicit Impl(int threads) : tasks(threads) { select_instruction_set(); }

    /// Sets the points of the following tests.
    void take(std::span<const glm::vec3> points, std::span<const std::uint32_t> receivers,
        std::size_t lights)
    {
        make_point_set(points, receivers, lights > 1, set, tasks);
    }

    void test(const World& world, std::span<const glm::vec3> points, const Light& light,
        std::span<std::uint8_t> occluded)
    {
        if (points.empty()) return;
        // The points are exact: they were not computed relative to an eye.
        float farthest = farthest_coordinate(light, world.position);
        if (is_far_lamp(light, farthest)) farthest = std::max(farthest, largest_coordinate(points));
        const PencilSpace space = light_space(light, glm::dvec3(0), farthest);
        test_points({world, space}, set, memory, tasks, occluded);
        if (light.kind != Light::Kind::spot) return;
        const SpotCone cone = spot_cone(light);
        tasks.for_ranges(points.size(), 16384, [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last; ++k) {
                const glm::vec3 d = to_light(space, points[k]);
                if (has_shadow_ray(space, d) && !in_cone(cone, from_lamp(space, points[k], d)))
                    occluded[k] = 1;
            }
        });
    }

    Tasks tasks;
    PointSet set;
    ShadowMemory memory;
    std::vector<std::uint8_t> row; // (points) result of one light
};

Occlusion::Occlusion(int threads) : impl_(std::make_unique<Impl>(threads)) {}
Occlusion::~Occlusion() = default;

void Occlusion::test(const World& world, std::span<const glm::vec3> points, const Light& light,
    std::vector<std::uint8_t>& occluded, std::span<const std::uint32_t> receivers)
{
    check_occlusion(world, points.size(), {&light, 1}, receivers);
    occluded.resize(points.size());
    impl_->take(points, receivers, 1);
    impl_->test(world, points, light, occluded);
}

void Occlusion::test(const World& world, std::span<const glm::vec3> points,
    std::span<const Light> lights, const Answers& answers, std::span<const std::uint32_t> receivers)
{
    check_occlusion(world, points.size(), lights, receivers);
    impl_->row.resize(points.size());
    impl_->take(points, receivers, lights.size());
    for (std::size_t k = 0; k < lights.size(); ++k) {
        impl_->test(world, points, lights[k], impl_->row);
        answers(k, impl_->row);
    }
}

void Occlusion::test_packed(const World& world, std::span<const glm::vec3> points,
    std::span<const Light> lights, std::vector<std::uint8_t>& bits,
    std::span<const std::uint32_t> receivers)
{
    check_occlusion(world, points.size(), lights, receivers);
    const std::size_t bytes = (points.size() + 7) / 8;
    bits.resize(lights.size() * bytes);
    test(
        world, points, lights,
        [&](std::size_t light, std::span<const std::uint8_t> occluded) {
            pack_bits(occluded, std::span(bits).subspan(light * bytes, bytes));
        },
        receivers);
}

int Occlusion::threads() const
{
    return impl_->tasks.threads();
}

void pack_bits(std::span<const std::uint8_t> values, std::span<std::uint8_t> bits)
{
    for (std::size_t byte = 0; byte < (values.size() + 7) / 8; ++byte) {
        const std::size_t count = std::min<std::size_t>(8, values.size() - 8 * byte);
        unsigned packed = 0;
        for (std::size_t k = 0; k < count; ++k) packed |= unsigned(values[8 * byte + k] & 1) << k;
        bits[byte] = static_cast<std::uint8_t>(packed);
    }
}

} // namespace firsthit
