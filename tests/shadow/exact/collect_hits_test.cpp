// collect_hits_test.cpp - collecting a tile's hits equals projecting its points one by one.
#include "shadow/exact/collect_hits.h"

#include "hits/hit_position.h"
#include "shadow/map/hit_picture.h"
#include "shadow/exact/lift_points.h"
#include "shadow/shadow_scenes.h"
#include "instruction_sets.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <map>
#include <vector>

namespace firsthit::test {
namespace {

/// The face, and the bits of x, y and w, by id. All w above kGreatestW count as equal, as they are
/// not stored (IrregularSample).
using FaceSamples = std::map<std::uint32_t, std::array<std::uint32_t, 4>>;

std::array<std::uint32_t, 4> with_bits(int face, float x, float y, float w)
{
    return {std::uint32_t(face), std::bit_cast<std::uint32_t>(x), std::bit_cast<std::uint32_t>(y),
        w < kGreatestW ? std::bit_cast<std::uint32_t>(w) : 0xFFFFFFFFu};
}

/// The face that sees the point, or -1.
int face_of(const PencilMesh& mesh, const glm::vec3& d)
{
    if (!has_shadow_ray(mesh.space, d)) return -1;
    if (mesh.space.directional) return 0;
    if (mesh.wide_face >= 0) {
        const glm::vec3 at = cube_face(false, mesh.wide_face).to_face_axes(d);
        if (at.z > 0 && std::abs(at.x) <= kWideFaceLimit * at.z &&
            std::abs(at.y) <= kWideFaceLimit * at.z)
            return mesh.wide_face;
    }
    int axis = std::abs(d.y) > std::abs(d.x) ? 1 : 0;
    if (std::abs(d.z) > std::abs(d[axis])) axis = 2;
    return 2 * axis + (d[axis] < 0);
}

/// Projects the hits on triangles that face the light one by one.
FaceSamples one_by_one(const PencilMesh& mesh, const HitTile& hits)
{
    FaceSamples samples;
    Effort effort;
    for (const HitRun& run : hits.runs) {
        if (light_side(mesh.space, mesh.corners(run.item), effort) != run.eye_side) continue;
        for (std::uint64_t rest = run.samples; rest; rest &= rest - 1) {
            const int k = std::countr_zero(rest), blocks_x = hits.size / kBlock;
            const float x = float(run.block % blocks_x * kBlock + block_x(k)),
                        y = float(run.block / blocks_x * kBlock + block_y(k));
            const auto id = std::uint32_t(run.block * kBlockSamples + k);
            const glm::vec3 p = hit_position(hits.rays, x, y, hits.t[id]);
            const glm::vec3 d = lift_point(mesh, run.item, to_light(mesh.space, p));
            const int number = face_of(mesh, d);
            if (number < 0) continue;
            const glm::vec3 at = cube_face(mesh.space.directional, number).to_face_axes(d);
            samples[id] = mesh.space.directional
                              ? with_bits(number, at.x, at.y, -at.z)
                              : with_bits(number, at.x / at.z, at.y / at.z, 1 / at.z);
        }
    }
    return samples;
}

FaceSamples collected(const PencilMesh& mesh, const HitTile& hits)
{
    const std::size_t points = std::size_t(hits.size * hits.size);
    TileReceivers receivers;
    PointChunk spare;
    spare.reserve(points);
    std::vector<IrregularSample> samples(chunk_room(points));
    std::vector<std::uint64_t> reached(hits.blocks());
    FacePatches patches;
    find_receivers(mesh, hits, receivers);
    collect_hits({hits, receivers.runs(), mesh}, {samples, 0}, reached, patches, spare);
    FaceSamples found;
    for (std::size_t face = 0; face < patches.size(); ++face) {
        const SamplePatch& patch = patches[face];
        for (std::size_t k = 0; k < patch.range.count; ++k) {
            const IrregularSample& s = samples[patch.range.first + k];
            EXPECT_TRUE(found.emplace(s.id, with_bits(int(face), s.x, s.y, s.w)).second);
            EXPECT_TRUE(s.x >= patch.bounds.x0 && s.x <= patch.bounds.x1 &&
                        s.y >= patch.bounds.y0 && s.y <= patch.bounds.y1);
            EXPECT_TRUE(!(s.w < patch.bounds.farthest_w) && !(s.w > patch.bounds.nearest_w));
            EXPECT_TRUE(reached[s.id / kBlockSamples] >> s.id % kBlockSamples & 1);
        }
    }
    return found;
}

class CollectHits : public testing::TestWithParam<std::size_t> {};

TEST_P(CollectHits, EqualsProjectingEachPointByItself)
{
    const ShadowWorld made = make_shadow_world(shadow_scenes()[GetParam()], 1);
    const World& world = made.world.world;
    Tasks tasks(1);
    const HitPicture picture(world, made.view, tasks, 32);
    std::size_t samples = 0;
    for (Light light : world.lights) {
        if (light.kind == Light::Kind::spot) light.kind = Light::Kind::point;
        PencilMesh mesh;
        make_pencil_mesh(light_space(light, made.view.camera.eye), world.position,
            world.scene->index, mesh, tasks);
        for (const auto& tile : picture.tiles) {
            const FaceSamples expected = one_by_one(mesh, tile->hits);
            samples += expected.size();
            for_instruction_sets([&] { EXPECT_EQ(collected(mesh, tile->hits), expected); });
        }
    }
    EXPECT_GT(samples, 0u);
}

INSTANTIATE_TEST_SUITE_P(
    Adversarial, CollectHits, testing::Range(std::size_t(0), shadow_scenes().size()));

TEST(CollectHits, HandlesBlocksOfAnyNumberOfRuns)
{
    for (const int n : {1, 2, 8, 40, 300}) { // n x n quads on a square that covers 64 x 64 samples
        TestWorld made;
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const auto at = [&](int x, int y) {
                    return glm::vec3(2 * float(x) / float(n) - 1, 2 * float(y) / float(n) - 1,
                        0.25f * float((x * 7 + y * 3) % 5) / float(n));
                };
                made.add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
                made.add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
            }
        made.finish();
        View view;
        view.width = view.height = 64;
        view.camera.eye = {0.1, 0.2, 3};
        view.camera.direction = {0, 0, -1};
        Tasks tasks(1);
        const HitPicture picture(made.world, view, tasks);
        for (const glm::dvec3& from :
            {glm::dvec3(1, 2, 3), glm::dvec3(0.25, 0.125, 0.5), glm::dvec3(0.1, 0, 40)}) {
            PencilMesh mesh;
            make_pencil_mesh(light_space(point_light(from), view.camera.eye), made.world.position,
                made.world.scene->index, mesh, tasks);
            const FaceSamples expected = one_by_one(mesh, picture.tiles[0]->hits);
            EXPECT_GT(expected.size(), 1000u);
            for_instruction_sets(
                [&] { EXPECT_EQ(collected(mesh, picture.tiles[0]->hits), expected); });
        }
    }
}

} // namespace
} // namespace firsthit::test
