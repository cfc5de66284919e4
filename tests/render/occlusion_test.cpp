// occlusion_test.cpp - which points lights do not reach, and which arguments are refused.
#include "message_of.h"
#include "scene/model/borrow.h"
#include "scenes.h"

#include <firsthit/firsthit.h>

#include <gtest/gtest.h>

#include <random>

namespace firsthit::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// A square of two triangles at y = 1, x and z from -1 to 1; a light above at y = 3.
struct Square {
    TestWorld world;
    Light above;

    Square()
    {
        world.add({-1, 1, -1}, {1, 1, -1}, {1, 1, 1});
        world.add({-1, 1, -1}, {1, 1, 1}, {-1, 1, 1});
        world.finish();
        above.position = {0, 3, 0};
    }

    Bytes test(const std::vector<glm::vec3>& points, const Light& light,
        const std::vector<std::uint32_t>& receivers = {}) const
    {
        Occlusion occlusion(1);
        Bytes occluded(77, 9); // is overwritten
        occlusion.test(world.world, points, light, occluded, receivers);
        return occluded;
    }
};

Light toward(const glm::dvec3& direction)
{
    Light light;
    light.kind = Light::Kind::directional;
    light.direction = direction;
    return light;
}

TEST(Occlusion, OfAPointLightIsBehindTheTriangleAndInItsPencil)
{
    const Square square;
    EXPECT_EQ(square.test(
                  {{0.1f, 0, 0}, {2.9f, -3, 0}, {3.1f, -3, 0}, {0, 2, 0}, {0, 4, 0}}, square.above),
        (Bytes{1, 1, 0, 0, 0}));
}

TEST(Occlusion, OfADirectionalLightIsAlongItsWay)
{
    const Square square;
    const std::vector<glm::vec3> points{{0.1f, 0, 0}, {1.9f, 0, 0}, {0.1f, 5, 0}, {0.1f, 1, 0}};
    EXPECT_EQ(square.test(points, toward({0, -2, 0})), (Bytes{1, 0, 0, 0}));
    EXPECT_EQ(square.test(points, toward({1, -1, 0})), (Bytes{1, 1, 0, 0}));
    EXPECT_EQ(square.test(points, toward({0, 1e-90, 0})), (Bytes{0, 0, 1, 0}));
}

TEST(Occlusion, OfASpotIsAlsoOutsideItsCone)
{
    const Square square;
    Light spot = square.above;
    spot.kind = Light::Kind::spot;
    spot.direction = {0, -1, 0};
    spot.outer_rad = 0.5;
    EXPECT_EQ(square.test({{0.1f, 2, 0}, {2, 2, 0}, {0.1f, 0, 0}, {0, 5, 0}, {0, 3, 0}}, spot),
        (Bytes{0, 1, 1, 1, 0}));
}

TEST(Occlusion, SkipsThePointsOwnTriangleAndAsksForNoSide)
{
    const Square square;
    // Below the square by more than the margins: the square shadows the point unless it is the
    // receiver.
    const std::vector<glm::vec3> points{{0.5f, 0.99f, -0.5f}, {0.5f, 0.99f, -0.5f}};
    EXPECT_EQ(square.test(points, square.above, {0, kNoItem}), (Bytes{0, 1}));
    EXPECT_EQ(square.test(points, square.above, {1, 0}), (Bytes{1, 0}));
    // The light is on the other side of the receiver, which makes no difference.
    Light below = square.above;
    below.position = {0, -3, 0};
    EXPECT_EQ(square.test({{0.5f, 1, -0.5f}}, below, {0}), (Bytes{0}));
}

TEST(Occlusion, IsNeverTrueOfPointsThatHaveNoRay)
{
    const Square square;
    EXPECT_EQ(
        square.test({{NAN, 0, 0}, {0, -INFINITY, 0}, {0, -1e30f, 0}, {0, 3, 0}}, square.above),
        (Bytes{0, 0, 0, 0}));
    EXPECT_EQ(square.test({{NAN, 0, 0}, {0, -INFINITY, 0}}, toward({0, -1, 0})), (Bytes{0, 0}));
}

TEST(Occlusion, OfNothingIsNothing)
{
    const Square square;
    EXPECT_TRUE(square.test({}, square.above).empty());
    TestWorld empty;
    empty.finish();
    Bytes occluded;
    Occlusion(1).test(empty.world, std::vector<glm::vec3>(3), square.above, occluded);
    EXPECT_EQ(occluded, Bytes(3, 0));
    Bytes bits(5, 1);
    Occlusion(1).test_packed(square.world.world, std::vector<glm::vec3>(3), {}, bits);
    EXPECT_TRUE(bits.empty());
}

/// Robots, points around them, and lights of each kind.
struct Crowd {
    Scene scene = load_scene("builtin:robots");
    World world;
    std::vector<glm::vec3> points;
    std::vector<Light> lights;

    Crowd()
    {
        pose(borrow(scene), 2, world);
        const auto box = bounds(world);
        std::mt19937 random(1);
        std::uniform_real_distribution<float> share(0, 1);
        for (int k = 0; k < 5003; ++k)
            points.push_back(box[0] + (box[1] - box[0]) *
                                          glm::vec3(share(random), share(random), share(random)));
        lights = {toward({0, -1, 0}), toward({-1, -0.3, 0.2}), world.lights.at(0)};
    }
};

TEST(Occlusion, HandsOverEachLightInTurnAndPacksTheSameBits)
{
    const Crowd crowd;
    Occlusion occlusion(2);
    std::vector<Bytes> rows;
    occlusion.test(crowd.world, crowd.points, crowd.lights,
        [&](std::size_t light, std::span<const std::uint8_t> occluded) {
            EXPECT_EQ(light, rows.size());
            rows.emplace_back(occluded.begin(), occluded.end());
        });
    ASSERT_EQ(rows.size(), 3u);
    Bytes bits;
    occlusion.test_packed(crowd.world, crowd.points, crowd.lights, bits);
    const std::size_t bytes = 626; // of 5003 points
    ASSERT_EQ(bits.size(), 3 * bytes);
    for (std::size_t light = 0; light < 3; ++light) {
        Bytes one;
        occlusion.test(crowd.world, crowd.points, crowd.lights[light], one);
        EXPECT_EQ(one, rows[light]);
        std::size_t dark = 0;
        for (std::size_t k = 0; k < one.size(); ++k) {
            EXPECT_EQ(bits[light * bytes + k / 8] >> (k % 8) & 1, one[k]);
            dark += one[k];
        }
        EXPECT_GT(dark, 50u);
        EXPECT_LT(dark, 4000u);
        EXPECT_EQ(bits[light * bytes + 625] >> 3, 0) << "what fills the last byte";
    }
}

TEST(Occlusion, DoesNotDependOnThreadsNorOnTheCallBefore)
{
    const Crowd crowd;
    Bytes expected, found;
    Occlusion one(1), three(3);
    one.test_packed(crowd.world, crowd.points, crowd.lights, expected);
    three.test_packed(crowd.world, std::span(crowd.points).first(10), crowd.lights, found);
    three.test_packed(crowd.world, crowd.points, crowd.lights, found);
    EXPECT_EQ(found, expected);
    EXPECT_EQ(three.threads(), 3);
}

TEST(Occlusion, RefusesWhatCannotBeTested)
{
    const Square square;
    const auto refused = [&](const Light& light, const std::vector<std::uint32_t>& receivers = {}) {
        return message_of<ArgumentError>(
            [&] { square.test(std::vector<glm::vec3>(2), light, receivers); });
    };
    EXPECT_NE(refused(toward({0, 0, 0})).find("light 0: its direction (0, 0, 0) is none"),
        std::string::npos);
    EXPECT_NE(refused(toward({0, NAN, 0})).find("direction"), std::string::npos);
    Light light;
    light.position = {0, INFINITY, 0};
    EXPECT_NE(refused(light).find("position"), std::string::npos);
    light = {.kind = Light::Kind::spot, .outer_rad = 4};
    EXPECT_NE(refused(light).find("cone"), std::string::npos);
    EXPECT_EQ(refused(square.above, {0}),
        "1 receivers for 2 points: one for each is accepted, or none at all");
    EXPECT_EQ(refused(square.above, {1, 2}),
        "receiver 2 of point 1 is no triangle: the scene has 2, numbered from 0");
}

TEST(PackBits, PutsTheFirstPointIntoTheLowestBit)
{
    Bytes bits(2, 0xFF);
    pack_bits(Bytes{1, 0, 0, 1, 0, 0, 0, 0, 0, 1}, bits);
    EXPECT_EQ(bits, (Bytes{0b1001, 0b10}));
}

} // namespace
} // namespace firsthit::test
