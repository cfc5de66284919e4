// map_fit_test.cpp - rectangles and sizes of maps; merging several faces into one.
#include "shadow/map/map_fit.h"
#include "shadow/map/merge_faces.h"

#include <gtest/gtest.h>

#include <cmath>

namespace firsthit {
namespace {

TEST(MapFit, CoversTheHitsAndNotMuchMore)
{
    for (const FaceBounds& bounds :
        {FaceBounds{-1, -1, 1, 1, 100000}, FaceBounds{0.25f, -0.5f, 0.75f, 0.0f, 1000000},
            FaceBounds{100, 200, 103, 201, 5000}, FaceBounds{-1e-6f, 0, 1e-6f, 1e-7f, 100}}) {
        const MapFit fit = map_fit(bounds, 0, 1);
        const double right = 0.5 * fit.width * fit.texel, down = 0.5 * fit.height * fit.texel;
        EXPECT_LE(fit.middle_x - right, double(bounds.x0));
        EXPECT_GE(fit.middle_x + right, double(bounds.x1));
        EXPECT_LE(fit.middle_y - down, double(bounds.y0));
        EXPECT_GE(fit.middle_y + down, double(bounds.y1));
        const double longer =
            std::max(double(bounds.x1) - double(bounds.x0), double(bounds.y1) - double(bounds.y0));
        EXPECT_LE(2 * std::max(right, down), 1.3 * longer + 1e-3 * std::abs(double(bounds.x0)));
    }
}

TEST(MapFit, HasAboutAsManyTexelsAsHits)
{
    for (const std::uint64_t hits : {100000u, 500000u, 1000000u, 5000000u}) {
        for (const float height : {1.0f, 0.3f}) {
            const MapFit fit = map_fit({-1, -height, 1, height, hits}, 0, 1);
            const double texels = double(fit.width) * fit.height;
            EXPECT_GT(texels, 0.6 * double(hits)) << hits << " " << height;
            EXPECT_LT(texels, 1.7 * double(hits)) << hits << " " << height;
        }
    }
    EXPECT_EQ(map_fit({-1, -1, 1, 1, 1}, 0, 1).width, kSmallestMap);
    EXPECT_EQ(map_fit({-1, -1, 1, 1, std::uint64_t(1) << 40}, 0, 1).width, kLargestMap);
}

TEST(MapFit, OfOnePointHasTexels)
{
    for (const float at : {0.0f, 1.0f, -1e20f}) {
        const MapFit fit = map_fit({at, at, at, at, 1}, 0, 1);
        EXPECT_GE(fit.width, 1);
        EXPECT_GE(fit.height, 1);
        EXPECT_GT(fit.texel, 0);
        EXPECT_TRUE(std::isfinite(fit.middle_x));
    }
}

TEST(MapFit, LeavesRoomForTheFilter)
{
    const MapFit fit = map_fit({-1, -1, 1, 1, 65536}, 64, 9);
    EXPECT_GE(0.5 * fit.width * fit.texel, 1 + 4.5 * fit.texel);
}

TEST(MapFit, OfNoHitsIsNone)
{
    EXPECT_EQ(map_fit({}, 0, 1).width, 0);
    EXPECT_EQ(map_fit({}, 512, 1).width, 0);
}

TEST(MergeFaces, MergesNeighbouringFaces)
{
    // Hits around +z (face 4), and a few on +x (face 0, whose x is y / x and whose y is z / x).
    LightBounds bounds;
    bounds[4] = {-0.5f, -0.25f, 1.0f, 0.25f, 10};
    bounds[0] = {-0.125f, 0.8f, 0.125f, 1.0f, 5};
    merge_faces(bounds);
    EXPECT_EQ(bounds[0].hits, 0u);
    EXPECT_EQ(bounds[4].hits, 15u);
    EXPECT_FLOAT_EQ(bounds[4].x0, -0.5f);
    EXPECT_FLOAT_EQ(bounds[4].x1, 1.25f);
    EXPECT_FLOAT_EQ(bounds[4].y0, -0.25f);
    EXPECT_FLOAT_EQ(bounds[4].y1, 0.25f);
}

TEST(MergeFaces, KeepsFacesThatNoSingleFaceSees)
{
    LightBounds opposite;
    opposite[4] = {-0.5f, -0.5f, 0.5f, 0.5f, 10};
    opposite[5] = {-0.5f, -0.5f, 0.5f, 0.5f, 10};
    merge_faces(opposite);
    EXPECT_EQ(opposite[4].hits, 10u);
    EXPECT_EQ(opposite[5].hits, 10u);

    // On face 0 z / x goes down to 0.4, beyond 63 degrees of +z; on face 4 x / z goes down to -1,
    // behind +x.
    LightBounds wide;
    wide[4] = {-1.0f, -0.25f, 1.0f, 0.25f, 10};
    wide[0] = {-0.125f, 0.4f, 0.125f, 1.0f, 5};
    merge_faces(wide);
    EXPECT_EQ(wide[4].hits, 10u);
    EXPECT_EQ(wide[0].hits, 5u);
}

} // namespace
} // namespace firsthit
