// hit_position_test.cpp - points lie on their rays, at their depth.
#include "hits/hit_position.h"
#include "hits/block_samples.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace firsthit {
namespace {

TEST(HitPosition, IsOnTheRayAtTheDepthAsked)
{
    const Rays rays{.eye = {1, 2, 3},
        .step_x = 1.0f / 64,
        .right = {1, 0, 0},
        .step_y = 1.0f / 32,
        .down = {0.5f, -1, 0},
        .x0 = -31.5f,
        .forward = {0, 0, -1},
        .y0 = 0.5f};
    const glm::vec3 p = hit_position(rays, 63, 7, 128);
    EXPECT_EQ(p, glm::vec3(1 + 31.5f * 2 + 7.5f * 2, 2 - 7.5f * 4, 3 - 128));
}

TEST(HitPosition, OfDepthZeroIsTheEye)
{
    Rays rays;
    rays.eye = {1, 2, 3};
    EXPECT_EQ(hit_position(rays, 5, 9, 0), rays.eye);
}

TEST(BlockSamples, AreInTileOrder)
{
    for (int y = 0; y < kBlock; ++y)
        for (int x = 0; x < kBlock; ++x) {
            EXPECT_EQ(kBlockSamplesXY.x[block_offset(x, y)], static_cast<float>(x));
            EXPECT_EQ(kBlockSamplesXY.y[block_offset(x, y)], static_cast<float>(y));
        }
}

} // namespace
} // namespace firsthit
