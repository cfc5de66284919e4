// coverage_test.cpp - the share of a pixel's samples that see a surface.
#include "scenes.h"

#include <firsthit/firsthit.h>

#include <gtest/gtest.h>

#include <cmath>

namespace firsthit::test {
namespace {

/// A triangle that covers part of the picture.
TestWorld wedge()
{
    TestWorld made;
    made.add({-3, -2, 10}, {4, 1, 10}, {-1, 3, 10});
    made.finish();
    return made;
}

Film render_alpha(const World& world, const View& view, int samples, bool alpha = true)
{
    Settings settings;
    settings.samples = samples;
    settings.alpha = alpha;
    Film film;
    Renderer(2).render(world, view, settings, film);
    return film;
}

/// Whether a point of the picture lies in the projected triangle, by the signs of three areas.
bool inside(double x, double y, double f, const View& view)
{
    const double corners[3][2] = {{-3, -2}, {4, 1}, {-1, 3}};
    const double px = (x - 0.5 * view.width) / f * 10, py = (y - 0.5 * view.height) / f * 10;
    int signs = 0;
    for (int k = 0; k < 3; ++k) {
        const double* a = corners[k];
        const double* b = corners[(k + 1) % 3];
        signs += (b[0] - a[0]) * (py - a[1]) - (b[1] - a[1]) * (px - a[0]) > 0;
    }
    return signs == 0 || signs == 3;
}

TEST(Coverage, IsTheShareOfSamplesInTheTriangle)
{
    const TestWorld made = wedge();
    const double f = 61.3;
    View view = straight_view(64, 48, f);
    for (const int n : {1, 2, 3, 4}) {
        const Film film = render_alpha(made.world, view, n);
        ASSERT_EQ(film.alpha.value.size(), 64u * 48u);
        int partly = 0;
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x) {
                int seen = 0;
                for (int sy = 0; sy < n; ++sy)
                    for (int sx = 0; sx < n; ++sx)
                        seen += inside(x + (sx + 0.5) / n, y + (sy + 0.5) / n, f, view);
                const float alpha = film.alpha.value[std::size_t(y * 64 + x)];
                ASSERT_EQ(alpha, float(seen) / float(n * n)) << n << ": " << x << ", " << y;
                partly += alpha > 0 && alpha < 1;
            }
        EXPECT_EQ(partly > 0, n > 1);
    }
}

TEST(Coverage, OfARegionIsThatOfThePicture)
{
    const TestWorld made = wedge();
    View view = straight_view(64, 48, 61.3);
    const Film whole = render_alpha(made.world, view, 3);
    view.region = {20, 11, 30, 19};
    const Film part = render_alpha(made.world, view, 3);
    for (int y = 0; y < 19; ++y)
        for (int x = 0; x < 30; ++x)
            ASSERT_EQ(part.alpha.value[std::size_t(y * 30 + x)],
                whole.alpha.value[std::size_t((y + 11) * 64 + x + 20)]);
}

TEST(Coverage, ColoursBeforeBlackAreThoseTimesAlpha)
{
    TestWorld made = wedge();
    const View view = straight_view(64, 48, 61.3);
    made.scene->materials[0].model = Unlit{.color = {0.5f, 0.25f, 1.0f}};
    made.scene->background = glm::vec3(0);
    const Film film = render_alpha(made.world, view, 4);
    for (std::size_t k = 0; k < film.alpha.value.size(); ++k)
        ASSERT_NEAR(film.color.value[3 * k], 0.5f * film.alpha.value[k], 1e-6);
}

TEST(Coverage, OfBlendedSurfacesIsTheirOpacity)
{
    TestWorld made = wedge();
    const View view = straight_view(64, 48, 61.3);
    const Film opaque = render_alpha(made.world, view, 2);
    made.scene->materials[0].model = Unlit{};
    made.scene->materials[0].alpha = AlphaMode::blend;
    made.scene->materials[0].opacity = 0.25f;
    const Film film = render_alpha(made.world, view, 2);
    for (std::size_t k = 0; k < film.alpha.value.size(); ++k)
        ASSERT_NEAR(film.alpha.value[k], 0.25f * opaque.alpha.value[k], 1e-6);
}

TEST(Coverage, IsMadeOnlyWhereItIsAskedFor)
{
    const TestWorld made = wedge();
    const View view = straight_view(16, 16, 20);
    EXPECT_TRUE(render_alpha(made.world, view, 2, false).alpha.empty());
}

} // namespace
} // namespace firsthit::test
