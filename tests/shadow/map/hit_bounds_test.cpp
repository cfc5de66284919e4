// hit_bounds_test.cpp - bounds of hits, against the bounds of every hit in double precision.
#include "instruction_sets.h"
#include "shadow/map/map_scenes.h"

namespace firsthit::test {
namespace {

/// The bounds of each face in double precision. Hits within a millionth of a face's border may be
/// on either face.
LightBounds plain_bounds(const HitPicture& picture, const LightFrame& frame)
{
    LightBounds bounds;
    picture.for_hits([&](std::size_t, const HitTile& hits, int x, int y, int offset) {
        const glm::dvec3 p(hit_position(hits.rays, float(x), float(y), hits.t[offset]));
        const glm::dvec3 q = frame.axes * (p - frame.origin);
        const glm::dvec3 size = glm::abs(q);
        int face = kOnlyFace;
        if (frame.cube) {
            const int axis = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
            face = 2 * axis + (q[axis] < 0 ? 1 : 0);
        }
        if (frame.tan2_cone > 0 &&
            (q.z <= 0 || q.x * q.x + q.y * q.y > frame.tan2_cone * q.z * q.z))
            return;
        const glm::dvec3 f = face_matrix(frame, face) * (p - frame.origin);
        const double scale = frame.parallel ? 1 : f.z;
        const float u = float(f.x / scale), v = float(f.y / scale);
        bounds[std::size_t(face)].add({u, v, u, v, 1});
    });
    return bounds;
}

void expect_bounds(const TestWorld& world, const Light& light)
{
    Tasks tasks(1);
    const HitPicture picture(world.world, straight_view(160, 160, 60), tasks);
    const LightFrame frame = light_frame(light);
    const LightBounds plain = plain_bounds(picture, frame);
    for_instruction_sets([&] {
        LightBounds ours;
        for (const auto& tile : picture.tiles) add_hits(tile->hits, frame, ours);
        for (int face = 0; face < kFaces; ++face) {
            SCOPED_TRACE(face);
            const FaceBounds &a = ours[std::size_t(face)], &b = plain[std::size_t(face)];
            EXPECT_NEAR(double(a.hits), double(b.hits), 1 + 1e-3 * double(b.hits));
            if (a.hits == 0 || b.hits == 0) continue;
            // No hit is outside, and rectangles are at most one block larger. A block is a 20th of
            // the picture here, and more than that of the far end of the floor.
            const float size = std::max(b.x1 - b.x0, b.y1 - b.y0), slack = 1e-5f * size;
            EXPECT_LE(a.x0, b.x0 + slack);
            EXPECT_LE(a.y0, b.y0 + slack);
            EXPECT_GE(a.x1, b.x1 - slack);
            EXPECT_GE(a.y1, b.y1 - slack);
            EXPECT_LE(std::max(a.x1 - a.x0, a.y1 - a.y0), 1.4f * size);
        }
    });
}

TEST(HitBounds, HoldEveryHitOfAPointLight)
{
    expect_bounds(box_over_floor(), point_light({1, -3, 5}));
    TestWorld room;
    add_box(room, {-3, -2, -1}, {3, 2, 9});
    room.finish();
    expect_bounds(room, point_light({0.1, 0.2, 3.7}));
}

TEST(HitBounds, HoldEveryHitOfADirectionalLight)
{
    expect_bounds(box_over_floor(), directional_light({0.3, 1, -0.2}));
}

TEST(HitBounds, HoldTheHitsInsideASpotsCone)
{
    expect_bounds(box_over_floor(), spot_light({1, -3, 5}, {-0.2, 1, 0.2}, 0.4));
    expect_bounds(box_over_floor(), spot_light({1, 0, 5}, {-0.2, 1, 0.2}, 1.3));
}

} // namespace
} // namespace firsthit::test
