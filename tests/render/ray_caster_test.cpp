// ray_caster_test.cpp - any rays at posed scenes: the same answers as pictures have, whatever the threads, and a tree
// that is made for rays alone.
#include "cpu/adversarial_scenes.h"
#include "cutouts.h"
#include "instruction_sets.h"
#include "items.h"
#include "message_of.h"
#include "rays/tree/ray_tree.h"
#include "scene/model/borrow.h"
#include "scenes.h"

#include <firsthit/firsthit.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace firsthit::test {
namespace {

constexpr int kFocal = 64; // a power of two: eye space is world space with exact factors

/// The camera at the origin whose rays are exact in world space.
View exact_view()
{
    View view = straight_view(kSize, kSize, kFocal);
    view.camera.focal = glm::dvec2(kFocal);
    return view;
}

/// The rays of its pixels, lengthened by kFocal / 2 so that they are whole numbers.
std::vector<Ray> pixel_rays()
{
    std::vector<Ray> rays;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x)
            rays.push_back(
                {glm::vec3(0), glm::vec3(2 * x + 1 - kSize, 2 * y + 1 - kSize, 2 * kFocal)});
    return rays;
}

/// Moves corners to where kFocal makes the eye space out of them that the scene was made for.
void fit_to_focal(TestWorld& world)
{
    for (glm::vec3& p : world.world.position)
        for (int axis = 0; axis < 2; ++axis)
            p[axis] = float(double(p[axis]) * kSize) / float(kFocal);
    world.scene->position = world.world.position;
}

std::vector<std::uint32_t> triangles_of(const std::vector<RayHit>& hits)
{
    std::vector<std::uint32_t> ids;
    for (const RayHit& hit : hits) ids.push_back(hit.triangle);
    return ids;
}

/// The rays of a camera hit what its picture shows, also of cut-outs: the rasteriser is the oracle.
TEST(RayCaster, SeesWhatPicturesShow)
{
    RayCaster caster(2);
    std::size_t seen = 0;
    for (const AdversarialScene& scene : adversarial_scenes())
        for (unsigned seed = 0; seed < 4; ++seed) {
            SCOPED_TRACE(scene.name + ", seed " + std::to_string(seed));
            std::mt19937 random(seed);
            TestWorld world;
            scene.fill(world, random);
            fit_to_focal(world);
            world.finish();
            if (seed >= 2) make_cutouts(world, random, seed % 2 == 0);
            std::vector<RayHit> hits;
            caster.nearest(world.world, pixel_rays(), hits);
            const auto items = items_of(world.world, exact_view());
            EXPECT_EQ(triangles_of(hits), items);
            for (const std::uint32_t item : items) seen += item != kNoItem;
        }
    EXPECT_GT(seen, 10000U);
}

std::vector<Ray> rays_of(const World& world, std::size_t count)
{
    std::mt19937 random(1);
    const auto box = bounds(world);
    const auto place = [&] {
        glm::vec3 p;
        for (int axis = 0; axis < 3; ++axis)
            p[axis] = std::uniform_real_distribution<float>(box[0][axis], box[1][axis])(random);
        return p;
    };
    std::vector<Ray> rays;
    for (std::size_t k = 0; k < count; ++k) {
        const glm::vec3 from = place();
        rays.push_back({from, place() - from});
    }
    return rays;
}

TEST(RayCaster, HasTheSameBitsOnAnyNumberOfThreads)
{
    World world;
    pose(load_scene("builtin:robots"), 1, world);
    const std::vector<Ray> rays = rays_of(world, 5000);
    RayCaster one(1), three(3);
    std::vector<RayHit> a, b;
    one.nearest(world, rays, a);
    three.nearest(world, rays, b);
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(RayHit)), 0);
    RayHitLists all_a, all_b;
    one.all_hits(world, rays, all_a);
    three.all_hits(world, rays, all_b);
    EXPECT_EQ(all_a.first, all_b.first);
    ASSERT_EQ(all_a.hit.size(), all_b.hit.size());
    EXPECT_EQ(
        std::memcmp(all_a.hit.data(), all_b.hit.data(), all_a.hit.size() * sizeof(RayHit)), 0);
    // The four answers are of the same hits.
    std::vector<std::uint8_t> occluded;
    std::vector<std::uint32_t> count;
    three.occluded(world, rays, occluded);
    three.count(world, rays, count);
    std::size_t hits = 0;
    for (std::size_t k = 0; k < rays.size(); ++k) {
        ASSERT_EQ(count[k], all_a.first[k + 1] - all_a.first[k]);
        ASSERT_EQ(occluded[k], count[k] > 0);
        if (count[k] == 0) {
            EXPECT_EQ(a[k].triangle, kNoItem);
            continue;
        }
        ++hits;
        ASSERT_EQ(std::memcmp(&a[k], &all_a.hit[all_a.first[k]], sizeof(RayHit)), 0);
        // The normal is of the corners' order, and the hit where t says.
        const glm::uvec3 c = world.scene->index[a[k].triangle];
        const glm::dvec3 v0(world.position[c.x]), v1(world.position[c.y]), v2(world.position[c.z]);
        const glm::dvec3 n = glm::normalize(glm::cross(v1 - v0, v2 - v0));
        EXPECT_LT(glm::length(n - glm::dvec3(a[k].normal)), 1e-6);
        const glm::dvec3 at =
            glm::dvec3(rays[k].origin) + double(a[k].t) * glm::dvec3(rays[k].direction);
        const glm::dvec3 on = v0 + double(a[k].u) * (v1 - v0) + double(a[k].v) * (v2 - v0);
        EXPECT_LT(glm::length(at - on), 1e-3);
    }
    EXPECT_GT(hits, 500U);
}

/// A tree is built by the first rays, refitted after a move, and kept otherwise.
TEST(RayCaster, FollowsTheWorld)
{
    const auto scene = std::make_shared<const Scene>(load_scene("builtin:robots"));
    World world;
    pose(scene, 0, world);
    const std::vector<Ray> rays = rays_of(world, 300);
    RayCaster caster(1);
    std::vector<RayHit> hits, again, fresh;
    EXPECT_EQ(caster.updates().builds, 0U);
    caster.nearest(world, rays, hits);
    caster.nearest(world, rays, again);
    EXPECT_EQ(triangles_of(hits), triangles_of(again));
    EXPECT_EQ(caster.updates().builds, 1U);
    EXPECT_EQ(caster.updates().refits, 0U);
    pose(scene, 3, world);
    caster.nearest(world, rays, hits);
    EXPECT_EQ(caster.updates().refits, 1U);
    RayCaster(1).nearest(world, rays, fresh);
    EXPECT_EQ(triangles_of(hits), triangles_of(fresh));
    world.position[7].x += 1;
    caster.nearest(world, rays, hits);
    EXPECT_EQ(caster.updates().refits, 2U);
    // Another scene.
    TestWorld other;
    other.add({-1, -1, 2}, {1, -1, 2}, {0, 1, 2});
    caster.nearest(other.finish(), pixel_rays(), hits);
    EXPECT_EQ(hits[kSize * kSize / 2 + kSize / 2].triangle, 0U);
}

TEST(RayCaster, FramesBuildNoTree)
{
    const RayTree::Counts before = RayTree::counts();
    World world;
    pose(load_scene("builtin:robots"), 1, world);
    View view;
    view.camera = world.camera;
    view.width = view.height = 64;
    Settings settings;
    settings.shadows = Shadows::exact;
    Film film;
    Renderer renderer(2);
    renderer.render(world, view, settings, film);
    renderer.render(world, view, settings, film);
    EXPECT_EQ(RayTree::counts().builds, before.builds);
    EXPECT_EQ(RayTree::counts().refits, before.refits);
}

TEST(RayCaster, RefusesWhatIsWrong)
{
    RayCaster caster(1);
    std::vector<RayHit> hits;
    EXPECT_EQ(message_of<ArgumentError>([&] { caster.nearest(World{}, {}, hits); }),
        "the world has no scene: pose it first");
    TestWorld world;
    world.add({-1, -1, 2}, {1, -1, 2}, {0, 1, 2});
    world.finish();
    std::vector<Ray> rays = pixel_rays();
    rays[3].skip = 1;
    EXPECT_EQ(message_of<ArgumentError>([&] { caster.nearest(world.world, rays, hits); }),
        "ray 3: 1 is no triangle to skip: the scene has 1, numbered from 0");
    std::stop_source stop;
    stop.request_stop();
    EXPECT_EQ(message_of<Cancelled>(
                  [&] { caster.nearest(world.world, pixel_rays(), hits, stop.get_token()); }),
        "the rays were cancelled");
    world.world.position.pop_back();
    EXPECT_EQ(message_of<ArgumentError>([&] { caster.nearest(world.world, pixel_rays(), hits); }),
        "the world has 2 positions, its scene 3 vertices");
}

TEST(RayCaster, OfNothing)
{
    RayCaster caster(2);
    TestWorld world;
    world.finish();
    std::vector<RayHit> hits;
    RayHitLists lists;
    caster.nearest(world.world, pixel_rays(), hits);
    for (const RayHit& hit : hits) EXPECT_EQ(hit.triangle, kNoItem);
    caster.all_hits(world.world, {}, lists);
    EXPECT_EQ(lists.first, std::vector<std::size_t>{0});
}

} // namespace
} // namespace firsthit::test
