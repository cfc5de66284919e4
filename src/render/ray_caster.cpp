// ray_caster.cpp - casts any rays at posed scenes, by a tree that follows the scene.
#include "base/instruction_set.h"
#include "base/tasks.h"
#include "exact/cutouts.h"
#include "rays/tree/cast_rays.h"

#include <firsthit/error.h>
#include <firsthit/ray_caster.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace firsthit {
namespace {

constexpr std::size_t kRaysATask = 512;

void check_rays(const World& world, std::span<const Ray> rays)
{
    if (!world.scene) throw ArgumentError("the world has no scene: pose it first");
    if (world.position.size() != world.scene->vertices)
        throw ArgumentError(fmt::format("the world has {} positions, its scene {} vertices",
            world.position.size(), world.scene->vertices));
    const std::size_t triangles = world.scene->index.size();
    for (std::size_t k = 0; k < rays.size(); ++k)
        if (rays[k].skip != kNoItem && rays[k].skip >= triangles)
            throw ArgumentError(fmt::format("ray {}: {} is no triangle to skip: the scene has {}, "
                                            "numbered from 0",
                k, rays[k].skip, triangles));
}

} // namespace

struct RayCaster::Impl {
    explicit Impl(int threads) : tasks(threads) { select_instruction_set(); }

    /// Has the tree follow the world.
    void follow(const World& world)
    {
        const WorldTriangles triangles{world.position, world.scene->index};
        const bool is_new = world.scene != scene;
        if (!is_new && position.size() == world.position.size() &&
            (position.empty() || std::memcmp(position.data(), world.position.data(),
                                     position.size() * sizeof(position[0])) == 0))
            return;
        if (is_new) {
            scene = nullptr; // in case that building throws
            cutouts.find(*world.scene, kSeenOpacity);
            tree.build(triangles, tasks);
            ++updates.builds;
        } else {
            updates.builds += tree.refit(triangles, tasks);
            ++updates.refits;
        }
        position = world.position;
        scene = world.scene;
    }

    /// Calls body(first, last) for ranges of rays.
    template <class Body>
    void for_rays(std::size_t count, const std::stop_token& stop, const Body& body)
    {
        tasks.for_ranges(count, kRaysATask, [&](std::size_t first, std::size_t last) {
            if (!stop.stop_requested()) body(first, last);
        });
        if (stop.stop_requested()) throw Cancelled("the rays were cancelled");
    }

    CastTarget target() const { return {tree, *scene, cutouts}; }

    Tasks tasks;
    std::shared_ptr<const Scene>
        scene;                       // that the tree is of; kept, so that its address stays its own
    std::vector<glm::vec3> position; // that the tree was fitted to
    Cutouts cutouts;
    RayTree tree;
    Updates updates;
};

RayCaster::RayCaster(int threads) : impl_(std::make_unique<Impl>(threads)) {}
RayCaster::~RayCaster() = default;

void RayCaster::nearest(
    const World& world, std::span<const Ray> rays, std::vector<RayHit>& hits, std::stop_token stop)
{
    check_rays(world, rays);
    impl_->follow(world);
    hits.resize(rays.size());
    const CastTarget target = impl_->target();
    impl_->for_rays(rays.size(), stop, [&](std::size_t first, std::size_t last) {
        cast_nearest(target, rays.subspan(first, last - first), std::span(hits).subspan(first));
    });
}

void RayCaster::occluded(const World& world, std::span<const Ray> rays,
    std::vector<std::uint8_t>& occluded, std::stop_token stop)
{
    check_rays(world, rays);
    impl_->follow(world);
    occluded.resize(rays.size());
    const CastTarget target = impl_->target();
    impl_->for_rays(rays.size(), stop, [&](std::size_t first, std::size_t last) {
        cast_any(target, rays.subspan(first, last - first), std::span(occluded).subspan(first));
    });
}

void RayCaster::count(const World& world, std::span<const Ray> rays,
    std::vector<std::uint32_t>& count, std::stop_token stop)
{
    check_rays(world, rays);
    impl_->follow(world);
    count.resize(rays.size());
    const CastTarget target = impl_->target();
    impl_->for_rays(rays.size(), stop, [&](std::size_t first, std::size_t last) {
        cast_count(target, rays.subspan(first, last - first), std::span(count).subspan(first));
    });
}

void RayCaster::all_hits(
    const World& world, std::span<const Ray> rays, RayHitLists& hits, std::stop_token stop)
{
    check_rays(world, rays);
    impl_->follow(world);
    const CastTarget target = impl_->target();
    std::vector<std::uint32_t> count(rays.size());
    std::vector<std::vector<RayHit>> part((rays.size() + kRaysATask - 1) / kRaysATask);
    impl_->for_rays(rays.size(), stop, [&](std::size_t first, std::size_t last) {
        cast_all(target, rays.subspan(first, last - first), std::span(count).subspan(first),
            part[first / kRaysATask]);
    });
    hits.first.resize(rays.size() + 1);
    hits.first[0] = 0;
    for (std::size_t k = 0; k < rays.size(); ++k) hits.first[k + 1] = hits.first[k] + count[k];
    hits.hit.clear();
    hits.hit.reserve(hits.first.back());
    for (const std::vector<RayHit>& some : part)
        hits.hit.insert(hits.hit.end(), some.begin(), some.end());
}

int RayCaster::threads() const
{
    return impl_->tasks.threads();
}

RayCaster::Updates RayCaster::updates() const
{
    return impl_->updates;
}

} // namespace firsthit
