// shade_tile_test.cpp - colours and planes with known results.
#include "shade/tile_scene.h"

#include <gtest/gtest.h>

namespace firsthit {
namespace {

void expect_near(glm::vec3 a, glm::vec3 b, float tolerance = 2e-6f)
{
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(a[axis], b[axis], tolerance) << "axis " << axis;
}

/// A sample straight ahead: the tile's first sample is on the view axis.
struct Ahead : TileScene {
    ShadeMemory memory;
    Ahead() : TileScene(8) { hits.rays.x0 = hits.rays.y0 = 0; }
    glm::vec3 color()
    {
        cast();
        shade_tile(hits, world, {}, memory.targets);
        return at(memory.targets.color, 0, 0, hits.size);
    }
};

TEST(ShadeTile, APlaneThatFacesItsLightIsExactlyAmbientPlusDiffuse)
{
    Ahead ahead;
    ahead.material().ambient = {0.125f, 0.25f, 0.5f};
    ahead.material().diffuse = {0.5f, 0.25f, 0.125f};
    ahead.scene.ambient = {1, 0.5f, 2};
    ahead.add_wall();
    ahead.add_light({0, 0, 0});
    EXPECT_EQ(ahead.color(), glm::vec3(0.625f, 0.375f, 1.125f));
}

TEST(ShadeTile, LightThatComesAtSixtyDegreesCountsHalf)
{
    Ahead ahead;
    ahead.material().ambient = {0, 0, 0};
    ahead.material().diffuse = {0.5f, 0.5f, 0.5f};
    ahead.add_wall();
    ahead.add_light({10 * std::sqrt(3.0), 0, 0});
    expect_near(ahead.color(), glm::vec3(0.25f));
}

TEST(ShadeTile, LightsAddWhateverTheirNumber)
{
    Ahead ahead;
    ahead.material().ambient = {0, 0, 0};
    ahead.material().diffuse = {1, 1, 1};
    ahead.add_wall();
    for (int i = 0; i < 100; ++i) ahead.add_light({0, 0, 0}, {0.25f, i == 7 ? 1.0f : 0.0f, 0.5f});
    EXPECT_EQ(ahead.color(), glm::vec3(25, 1, 50));
}

TEST(ShadeTile, BothSidesOfATriangleLookTheSame)
{
    glm::vec3 color[2];
    for (int reversed = 0; reversed < 2; ++reversed) {
        Ahead ahead;
        ahead.material().specular = glm::vec3(0.5f);
        ahead.material().shininess = 3.5f;
        const glm::vec3 a(-20, -20, -10), b(30, -20, -14), c(-20, 40, -10);
        if (reversed)
            ahead.add_triangle(a, c, b);
        else
            ahead.add_triangle(a, b, c);
        ahead.add_light({3, 4, 0});
        color[reversed] = ahead.color();
        const glm::vec3 n = at(ahead.memory.targets.geometric_normal, 0, 0, 8);
        EXPECT_GT(n.z, 0) << "towards the eye";
        EXPECT_NEAR(glm::length(n), 1, 1e-6);
    }
    expect_near(color[0], color[1]);
}

TEST(ShadeTile, ALightBehindTheNormalAddsNothing)
{
    Ahead ahead;
    ahead.material().ambient = {0, 0, 0};
    ahead.material().specular = glm::vec3(1);
    ahead.add_wall();
    for (glm::vec3& n : ahead.world.normal) n = glm::normalize(glm::vec3(1, 0, 0.1f));
    ahead.add_light({-100, 0, -9});
    EXPECT_EQ(ahead.color(), glm::vec3(0));
}

TEST(ShadeTile, LightFadesEvenlyWhereItPassesBehindThePlane)
{
    glm::vec3 color[2];
    for (int behind = 0; behind < 2; ++behind) {
        Ahead ahead;
        ahead.material().ambient = {0, 0, 0};
        ahead.add_wall();
        for (glm::vec3& n : ahead.world.normal) n = glm::normalize(glm::vec3(1, 0, 1));
        ahead.add_light({100, 0, behind ? -10.0001 : -9.9999});
        color[behind] = ahead.color();
    }
    EXPECT_GT(color[0].x, 0.5f);
    expect_near(color[0], color[1], 1e-5f);
}

TEST(ShadeTile, NormalsThatOpposeTheWindingLookLikeThoseThatAgree)
{
    glm::vec3 color[2];
    for (int opposed = 0; opposed < 2; ++opposed) {
        Ahead ahead;
        ahead.add_wall();
        for (glm::vec3& n : ahead.world.normal) {
            n = glm::normalize(glm::vec3(0.5f, 0, 1));
            if (opposed) n = -n;
        }
        ahead.add_light({3, 4, 0});
        color[opposed] = ahead.color();
    }
    EXPECT_GT(color[0].x, 0.3f);
    EXPECT_EQ(color[0], color[1]);
}

TEST(ShadeTile, NormalsThatTurnAwayFromTheEyeAreBentToItsHorizon)
{
    Ahead ahead;
    ahead.add_wall();
    // Only the normal of the corner nearest to the sample points away from the eye.
    ahead.world.position = {{-1, -1, -10}, {100, -1, -10}, {-1, 100, -10}};
    ahead.world.normal = {glm::normalize(glm::vec3(1, 0, -0.5f)), {0, 0, 1}, {0, 0, 1}};
    ahead.scene.index = {{0, 1, 2}};
    ahead.color();
    expect_near(at(ahead.memory.targets.normal, 0, 0, 8), {1, 0, 0});
}

TEST(ShadeTile, MissingAndZeroNormalsAreThoseOfThePlane)
{
    for (const bool missing : {false, true}) {
        Ahead ahead;
        ahead.add_wall();
        for (glm::vec3& n : ahead.world.normal) n = glm::vec3(0);
        if (missing) ahead.world.normal.clear();
        ahead.color();
        EXPECT_EQ(at(ahead.memory.targets.normal, 0, 0, 8), glm::vec3(0, 0, 1));
    }
}

TEST(ShadeTile, TinyAndHugeTrianglesHaveNormals)
{
    for (const float scale : {1e-25f, 1e-10f, 1.0f, 1e15f}) {
        Ahead ahead;
        ahead.add_triangle(glm::vec3(-1, -1, -1) * scale, glm::vec3(4, -1, -1) * scale,
            glm::vec3(-1, 4, -1) * scale);
        for (glm::vec3& n : ahead.world.normal) n = {0, 0, 1};
        ahead.color();
        expect_near(at(ahead.memory.targets.geometric_normal, 0, 0, 8), {0, 0, 1});
    }
}

TEST(ShadeTile, HighlightsHaveTheExponentAsked)
{
    // The reflected direction R is 2 * 20 degrees away from the direction to the eye.
    for (const float shininess :
        {0.0f, 0.3f, 1.0f, 2.0f, 7.0f, 10.5f, 64.0f, 65.0f, 200.0f, 1e5f}) {
        Ahead ahead;
        ahead.material().ambient = ahead.material().diffuse = glm::vec3(0);
        ahead.material().specular = {1, 0.5f, 0.25f};
        ahead.material().shininess = shininess;
        ahead.add_wall();
        ahead.add_light({10 * std::tan(0.2), 0, 0});
        const double expected = std::pow(std::cos(0.2), double(shininess));
        const glm::vec3 color = ahead.color();
        EXPECT_NEAR(color.x, expected, 4e-6) << shininess;
        EXPECT_NEAR(color.y, expected / 2, 2e-6) << shininess;
        EXPECT_NEAR(color.z, expected / 4, 1e-6) << shininess;
    }
}

TEST(ShadeTile, AnExponentThatIsNoNumberOrNegativeCountsAsZero)
{
    for (const float shininess : {-3.0f, std::numeric_limits<float>::quiet_NaN()}) {
        Ahead ahead;
        ahead.material().ambient = ahead.material().diffuse = glm::vec3(0);
        ahead.material().specular = glm::vec3(1);
        ahead.material().shininess = shininess;
        ahead.add_wall();
        ahead.add_light({5, 0, 0});
        EXPECT_EQ(ahead.color(), glm::vec3(1));
    }
}

TEST(ShadeTile, PositionsAreWhereTheRaysMeetTheTriangle)
{
    TileScene tile(32);
    tile.hits.rays.eye = {3, -2, 5};
    tile.add_square({-97, -102, -5}, {200, 0, 0}, {0, 200, 0});
    tile.cast();
    ShadeMemory memory;
    shade_tile(tile.hits, tile.world, {}, memory.targets);
    for (int y = 0; y < 32; y += 5)
        for (int x = 0; x < 32; x += 3) {
            const glm::dvec3 p = glm::dvec3(tile.hits.rays.eye) + tile.direction(x, y) * 10.0;
            expect_near(at(memory.targets.position, x, y, 32), glm::vec3(p), 2e-6f);
        }
}

TEST(ShadeTile, SamplesWithoutAnItemAreBackgroundAndZero)
{
    TileScene tile(24);
    tile.add_triangle({-3, -3, -10}, {3, -3, -10}, {-3, 3, -10});
    tile.add_light({0, 0, 0});
    tile.cast();
    ShadeMemory memory;
    shade_tile(tile.hits, tile.world, {}, memory.targets);
    int missed = 0;
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 24; ++x) {
            if (tile.item[tile_offset(x, y, 24)] != kNoItem) continue;
            ++missed;
            EXPECT_EQ(at(memory.targets.color, x, y, 24), tile.scene.background);
            for (auto* plane : {&memory.targets.normal, &memory.targets.geometric_normal,
                     &memory.targets.position, &memory.targets.albedo})
                EXPECT_EQ(at(*plane, x, y, 24), glm::vec3(0));
            EXPECT_EQ(memory.targets.uv[0][tile_offset(x, y, 24)], 0);
        }
    EXPECT_GT(missed, 64);
    EXPECT_LT(missed, 24 * 24);
}

TEST(ShadeTile, EachRunWritesItsOwnSamplesAndNoOther)
{
    // 64 materials in one block, one sample each, in a scrambled order.
    TileScene tile(8);
    tile.add_wall();
    tile.cast();
    tile.runs.clear();
    for (int k = 0; k < 64; ++k) {
        const int sample = k * 37 % 64;
        Phong& material = tile.add_material();
        material.ambient = glm::vec3(static_cast<float>(sample));
        tile.scene.index.push_back(tile.scene.index[0]);
        tile.scene.owner.push_back(static_cast<std::uint32_t>(k + 1));
        tile.runs.push_back({static_cast<std::uint32_t>(k + 2), 0, 0, std::uint64_t(1) << sample});
    }
    tile.point_at_arrays();
    ShadeMemory memory;
    shade_tile(tile.hits, tile.world, {}, memory.targets);
    for (int sample = 0; sample < 64; ++sample)
        EXPECT_EQ(memory.targets.color[0][sample], static_cast<float>(sample));
}

TEST(ShadeTile, RunsMayComeInAnyOrderOfBlocks)
{
    TileScene tile(32);
    tile.add_wall();
    tile.add_triangle({-3, -3, -9}, {3, -3, -9}, {-3, 3, -9});
    tile.add_light({5, 5, 0});
    tile.cast();
    ShadeMemory in_order, reversed;
    shade_tile(tile.hits, tile.world, {}, in_order.targets);
    std::reverse(tile.runs.begin(), tile.runs.end());
    shade_tile(tile.hits, tile.world, {}, reversed.targets);
    for (int k = 0; k < 32 * 32; ++k)
        EXPECT_EQ(in_order.targets.color[0][k], reversed.targets.color[0][k]);
}

TEST(ShadeTile, WritesNothingWhereNothingIsAsked)
{
    TileScene tile(8);
    tile.add_wall();
    tile.cast();
    ShadeMemory memory;
    const ShadeTargets all = memory.targets;
    ShadeTargets only_position;
    for (int axis = 0; axis < 3; ++axis) only_position.position[axis] = all.position[axis];
    shade_tile(tile.hits, tile.world, {}, only_position);
    EXPECT_EQ(all.position[2][0], -10);
    EXPECT_EQ(all.color[0][0], -7);
    EXPECT_EQ(all.normal[0][0], -7);
    EXPECT_EQ(all.uv[0][0], -7);
    shade_tile(tile.hits, tile.world, {}, {});
}

} // namespace
} // namespace firsthit
