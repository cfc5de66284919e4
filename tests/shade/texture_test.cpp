// texture_test.cpp - compares texture sampling with a simple reference in double precision.
#include "shade/noise_texture.h"
#include "shade/tile_scene.h"

#include <gtest/gtest.h>

#include <random>

namespace firsthit {
namespace {

/// The largest difference: weights are integers up to 32767, and three roundings of a half add up.
constexpr double kRounding = 5e-5;

/// A texel of the picture; column and row are counted from the top left, and repeat.
glm::dvec3 texel(const Texture& texture, int level, long column, long row)
{
    const long width = texture.width(level), height = texture.height(level);
    const long x = (column % width + width) % width;
    const long y = (row % height + height) % height;
    return glm::dvec3(texture.color(level, int(x), int(y)));
}

glm::dvec3 bilinear(const Texture& texture, int level, double u, double v)
{
    const double x = u * texture.width(level) - 0.5;
    const double y = (1 - v) * texture.height(level) - 0.5;
    const long x0 = long(std::floor(x)), y0 = long(std::floor(y));
    const double right = x - double(x0), bottom = y - double(y0);
    const auto at = [&](long dx, long dy) { return texel(texture, level, x0 + dx, y0 + dy); };
    return (at(0, 0) * (1 - right) + at(1, 0) * right) * (1 - bottom) +
           (at(0, 1) * (1 - right) + at(1, 1) * right) * bottom;
}

glm::dvec3 trilinear(const Texture& texture, double u, double v, double level)
{
    const int last = texture.levels() - 1;
    const double clamped = std::min(std::max(level, 0.0), double(last));
    const int finer = int(clamped);
    const double amount = clamped - finer;
    return bilinear(texture, finer, u, v) * (1 - amount) +
           bilinear(texture, std::min(finer + 1, last), u, v) * amount;
}

/// Texture coordinates at a picture position, whole or not, on the plane of a triangle.
glm::dvec2 uv_at(const TileScene& tile, std::uint32_t triangle, double x, double y)
{
    const glm::dvec3 hit = tile.meet(triangle, x, y);
    const glm::uvec3 corner = tile.scene.index[triangle];
    return glm::dvec2(tile.scene.uv[corner.x]) * (1 - hit.y - hit.z) +
           glm::dvec2(tile.scene.uv[corner.y]) * hit.y +
           glm::dvec2(tile.scene.uv[corner.z]) * hit.z;
}

/// log2 of the longer side of a sample's footprint in texels, by small steps on the picture.
double numerical_level(const TileScene& tile, std::uint32_t triangle, double x, double y)
{
    const double h = 1e-4;
    const Texture& texture = tile.scene.textures[0];
    const glm::dvec2 size(texture.width(), texture.height());
    const auto side = [&](double dx, double dy) {
        return glm::length(
            size * (uv_at(tile, triangle, x + dx, y + dy) - uv_at(tile, triangle, x - dx, y - dy)) /
            (2 * h));
    };
    return std::log2(std::max(side(h, 0), side(0, h)));
}

/// Compares every sample's albedo with the reference. Returns the range of levels seen.
glm::dvec2 expect_reference(TileScene& tile, double tolerance)
{
    tile.material().texture = 0;
    tile.material().diffuse = glm::vec3(1);
    tile.cast();
    ShadeMemory memory;
    shade_tile(tile.hits, tile.world, {}, memory.targets);
    glm::dvec2 range(1e9, -1e9);
    for (int y = 0; y < tile.hits.size; ++y)
        for (int x = 0; x < tile.hits.size; ++x) {
            const std::uint32_t triangle = tile.item[tile_offset(x, y, tile.hits.size)];
            if (triangle == kNoItem) continue;
            const double level = numerical_level(tile, triangle, x, y);
            range = {std::min(range.x, level), std::max(range.y, level)};
            const glm::dvec2 uv = uv_at(tile, triangle, x, y);
            const glm::dvec3 expected = trilinear(tile.scene.textures[0], uv.x, uv.y, level);
            const glm::vec3 seen = at(memory.targets.albedo, x, y, tile.hits.size);
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_NEAR(seen[axis], expected[axis], tolerance)
                    << "(" << x << ", " << y << ") level " << level;
        }
    return range;
}

TEST(TextureSampling, IsBilinearWhereEnlarged)
{
    TileScene tile(32);
    tile.scene.textures.push_back(noise_texture(5, 3));
    tile.add_wall(10, 12);
    EXPECT_LT(expect_reference(tile, kRounding).y, 0);
}

TEST(TextureSampling, BlendsTwoLevelsWhereReduced)
{
    TileScene tile(32);
    tile.scene.textures.push_back(noise_texture(256, 128));
    tile.add_square({-12, -30, -10}, {24, 0, 6}, {3, 60, -40}, 3);
    const glm::dvec2 range = expect_reference(tile, 2e-4);
    EXPECT_GT(range.x, 0);
    EXPECT_GT(range.y - range.x, 1);
}

TEST(TextureSampling, TakesTheLevelOfRaysThatAreNotSquareToOneAnother)
{
    TileScene tile(32);
    tile.hits.rays.step_y *= 0.25f;
    tile.hits.rays.down = {0.5f, -1, 0};
    tile.hits.rays.forward = {0.125f, 0.25f, -1};
    tile.scene.textures.push_back(noise_texture(256, 128));
    tile.add_square({-12, -30, -10}, {24, 0, 6}, {3, 60, -40}, 3);
    const glm::dvec2 range = expect_reference(tile, 2e-4);
    EXPECT_GT(range.x, 0);
}

TEST(TextureSampling, TakesTheLevelOfAGrazingGroundFromItsSlope)
{
    // A ground that reaches the horizon, so that all levels occur.
    TileScene tile(64, 60);
    tile.scene.textures.push_back(noise_texture(256, 256));
    tile.add_square({-5000, -1, 0.5f}, {10000, 0, 0}, {0, 0, -10000}, 5000);
    const glm::dvec2 range = expect_reference(tile, 1e-2);
    EXPECT_LT(range.x, 4);
    EXPECT_GT(range.y, 8);
}

TEST(TextureSampling, IsTheLastLevelWhereReducedFurther)
{
    TileScene tile(8);
    tile.scene.textures.push_back(noise_texture(4, 4));
    tile.add_wall(10, 100, 1e6f);
    tile.material().texture = 0;
    tile.material().diffuse = glm::vec3(1);
    tile.cast();
    ShadeMemory memory;
    shade_tile(tile.hits, tile.world, {}, memory.targets);
    const glm::vec3 last(texel(tile.scene.textures[0], 2, 0, 0));
    for (int k = 0; k < 64; ++k) EXPECT_NEAR(memory.targets.albedo[0][k], last.x, 1e-6);
}

TEST(TextureSampling, RepeatsOutsideZeroToOne)
{
    glm::vec3 seen[3];
    const float shift[] = {0, -3, 7};
    for (int i = 0; i < 3; ++i) {
        TileScene tile(8);
        tile.scene.textures.push_back(noise_texture(4, 8));
        tile.add_wall(10, 8);
        for (glm::vec2& uv : tile.scene.uv) uv += glm::vec2(shift[i], -shift[i]);
        expect_reference(tile, kRounding);
        ShadeMemory memory;
        shade_tile(tile.hits, tile.world, {}, memory.targets);
        seen[i] = at(memory.targets.albedo, 2, 3, 8);
    }
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(seen[0][axis], seen[1][axis], 1e-5);
        EXPECT_NEAR(seen[0][axis], seen[2][axis], 1e-5);
    }
}

TEST(TextureSampling, HasItsBottomRowAtVZero)
{
    // Two rows, red above green, upright on a wall: v grows upwards, as in OBJ.
    TileScene tile(16, 16);
    tile.scene.textures.emplace_back("two rows", Picture{1, 2, {0x0000FFu, 0x00FF00u}});
    tile.material().texture = 0;
    tile.material().diffuse = glm::vec3(1);
    tile.add_wall(10, 6);
    tile.cast();
    ShadeMemory memory;
    shade_tile(tile.hits, tile.world, {}, memory.targets);
    EXPECT_GT(at(memory.targets.albedo, 8, 4, 16).x, 0.8f) << "red above";
    EXPECT_GT(at(memory.targets.albedo, 8, 11, 16).y, 0.8f) << "green below";
}

TEST(TextureSampling, MultipliesAmbientAndDiffuseButNotSpecular)
{
    TileScene tile(8);
    tile.hits.rays.x0 = tile.hits.rays.y0 = 0;
    tile.scene.textures.emplace_back("no green", Picture{1, 1, {0xFF00FFu}});
    tile.material().texture = 0;
    tile.material().ambient = glm::vec3(0.125f);
    tile.material().diffuse = glm::vec3(0.25f);
    tile.material().specular = glm::vec3(0.5f);
    tile.add_wall();
    tile.add_light({0, 0, 0});
    tile.cast();
    ShadeMemory memory;
    shade_tile(tile.hits, tile.world, {}, memory.targets);
    EXPECT_EQ(at(memory.targets.color, 0, 0, 8), glm::vec3(0.875f, 0.5f, 0.875f));
    EXPECT_EQ(at(memory.targets.albedo, 0, 0, 8), glm::vec3(0.25f, 0, 0.25f));
}

TEST(TextureSampling, OfWhiteIsExactlyWhiteAtEveryLevelAndPlace)
{
    TileScene tile(64, 60);
    tile.scene.textures.emplace_back("white", Picture{64, 32, std::vector(64 * 32, 0xFFFFFFu)});
    tile.material().texture = 0;
    tile.material().diffuse = glm::vec3(1);
    tile.add_square({-5000, -1, 0.5f}, {10000, 0, 0}, {0, 0, -10000}, 5000);
    tile.cast();
    ShadeMemory memory;
    shade_tile(tile.hits, tile.world, {}, memory.targets);
    for (int k = 0; k < 64 * 64; ++k)
        EXPECT_EQ(memory.targets.albedo[1][k], tile.item[k] == kNoItem ? 0 : 1);
}

TEST(TextureSampling, ThatIsEmptyOrMissingIsWhite)
{
    for (const int number : {0, 5}) {
        SCOPED_TRACE(number);
        TileScene tile(8);
        tile.scene.textures.emplace_back();
        tile.material().texture = number;
        tile.material().diffuse = glm::vec3(1);
        tile.add_wall();
        tile.cast();
        ShadeMemory memory;
        shade_tile(tile.hits, tile.world, {}, memory.targets);
        EXPECT_EQ(at(memory.targets.albedo, 3, 3, 8), glm::vec3(1));
    }
}

TEST(TextureSampling, IsIgnoredWhereTheSceneHasNoCoordinates)
{
    TileScene tile(8);
    tile.scene.textures.push_back(noise_texture(4, 4));
    tile.material().texture = 0;
    tile.add_wall();
    tile.scene.uv.clear();
    tile.cast();
    ShadeMemory memory;
    shade_tile(tile.hits, tile.world, {}, memory.targets);
    EXPECT_EQ(at(memory.targets.albedo, 3, 3, 8), tile.material().diffuse);
    EXPECT_EQ(memory.targets.uv[0][0], 0);
}

TEST(TextureSampling, CoordinatesThatAreHugeOrNoNumberDoNotCrash)
{
    const float inf = std::numeric_limits<float>::infinity();
    for (const float bad : {inf, -inf, std::numeric_limits<float>::quiet_NaN(), 3e38f, -3e38f}) {
        TileScene tile(16);
        tile.scene.textures.push_back(noise_texture(16, 16));
        tile.material().texture = 0;
        tile.material().diffuse = glm::vec3(1);
        tile.add_wall();
        for (std::size_t k = 0; k < tile.scene.uv.size(); k += 2) tile.scene.uv[k].x = bad;
        tile.cast();
        ShadeMemory memory;
        shade_tile(tile.hits, tile.world, {}, memory.targets);
        for (int k = 0; k < 16 * 16; ++k) {
            EXPECT_GE(memory.targets.albedo[0][k], 0);
            EXPECT_LE(memory.targets.albedo[0][k], 1);
        }
    }
}

} // namespace
} // namespace firsthit
