// hit_position_test.cpp - points lie on their rays, at their depth.
#include "hits/hit_position.h"
#include "hits/block_samples.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace firsthit {
namespace {

TEST(HitPosition, IsOnTheRayAtTheDepthAsked)
{
    TileFrame frame;
    frame.x0 = -31.5f;
    frame.y0 = 0.5f;
    frame.inv_f = 1.0f / 64;
    frame.eye = {1, 2, 3};
    frame.world_from_eye = glm::mat3(1, 0, 0, 0, -1, 0, 0, 0, -1);
    const glm::vec3 p = hit_position(frame, 63, 7, 128);
    EXPECT_EQ(p, glm::vec3(1 + 31.5f * 2, 2 - 7.5f * 2, 3 - 128));
}

TEST(HitPosition, OfDepthZeroIsTheEye)
{
    TileFrame frame;
    frame.eye = {1, 2, 3};
    EXPECT_EQ(hit_position(frame, 5, 9, 0), frame.eye);
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
