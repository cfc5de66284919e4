// camera_test.cpp - pictures of calibrated cameras: focal lengths, principal point and skew.
#include "scene/model/borrow.h"
#include "scenes.h"

#include <firsthit/compare.h>
#include <firsthit/firsthit.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace firsthit::test {
namespace {

struct Intrinsics {
    glm::dvec2 focal, principal_point;
    double skew;
};

/// A camera for pictures of 96 x 64 pixels.
const std::vector<Intrinsics>& intrinsics()
{
    static const std::vector<Intrinsics> all{{{90.3, 57.7}, {48, 32}, 0},
        {{71, 71}, {40.37, 21.9}, 0}, {{110.25, 80.5}, {51.13, 35.77}, 7.3},
        {{60, 240}, {47.75, 30.25}, -21.5}, {{900.1, 700.3}, {-250.6, 130.2}, 3.1}};
    return all;
}

struct CameraPicture {
    Scene scene = load_scene("builtin:robots");
    World world;
    View view;
    Settings settings;

    CameraPicture()
    {
        pose(borrow(scene), 2.5, world);
        view.camera = world.camera;
        view.width = 96, view.height = 64;
        for (int k = 0; k < kAovCount; ++k) settings.aovs.push_back(Aov(k));
    }

    void use(const Intrinsics& of)
    {
        view.camera.focal = of.focal;
        view.camera.principal_point = of.principal_point;
        view.camera.skew = of.skew;
    }

    Film render(int threads = 1) const
    {
        Renderer renderer(threads);
        Film film;
        renderer.render(world, view, settings, film);
        return film;
    }

    /// The camera's axes: right, down, forward.
    glm::dmat3 axes() const
    {
        const glm::dvec3 z = glm::normalize(view.camera.direction),
                         x = glm::normalize(glm::cross(z, view.camera.up));
        return {x, glm::cross(z, x), z};
    }

    /// The ray through the middle of pixel (i, j), by the usual formula of a pinhole camera; depth
    /// 1.
    glm::dvec3 ray(int i, int j) const
    {
        const glm::dvec2 f = *view.camera.focal, c = *view.camera.principal_point;
        const double v = (j + 0.5 - c.y) / f.y;
        return axes() * glm::dvec3((i + 0.5 - c.x - view.camera.skew * v) / f.x, v, 1);
    }
};

void expect_equal(const Film& a, const Film& b)
{
    EXPECT_EQ(a.color.value, b.color.value);
    EXPECT_EQ(a.item, b.item);
    for (int k = 0; k < kAovCount; ++k)
        EXPECT_EQ(a[Aov(k)].value, b[Aov(k)].value) << aov_name(Aov(k));
}

glm::dvec3 vector_at(const Plane& plane, std::size_t pixel)
{
    return {plane.value[3 * pixel], plane.value[3 * pixel + 1], plane.value[3 * pixel + 2]};
}

TEST(CalibratedCamera, SeesAndShadowsWhatBruteForceSays)
{
    CameraPicture picture;
    for (const Intrinsics& of : intrinsics()) {
        SCOPED_TRACE(of.principal_point.x);
        picture.use(of);
        for (const Oracle oracle : {Oracle::brute, Oracle::embree}) {
            const Comparison items = compare(picture.world, picture.view, oracle, 2);
            EXPECT_EQ(items.ours_wrong, 0u);
            EXPECT_GT(double(items.agree), 0.999 * double(items.pixels));
            const LitComparison lit = compare_lit(picture.world, picture.view, oracle, 2);
            EXPECT_EQ(lit.ours_wrong, 0u);
            EXPECT_GT(lit.pixels, items.pixels / 20);
        }
    }
}

/// Triangles of a few pixels in a picture that is far beside the camera's axis.
TEST(CalibratedCamera, SeesWhatBruteForceSaysFarFromItsAxis)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    const Intrinsics of{{1000, 1300}, {-131000.3, 130900.6}, 11};
    TestWorld made;
    for (int k = 0; k < 600; ++k) {
        const double x = 120 * unit(random) - 10, y = 80 * unit(random) - 8, size = k % 4 ? 6 : 60;
        const auto corner = [&] {
            const double z = 1 + 9 * unit(random),
                         v = (y + size * unit(random) - of.principal_point.y) / of.focal.y,
                         u = (x + size * unit(random) - of.principal_point.x - of.skew * v) /
                             of.focal.x;
            return glm::vec3(glm::dvec3(u, v, 1) * z);
        };
        made.add(corner(), corner(), corner());
    }
    const World& world = made.finish();
    View view = straight_view(96, 64, 1);
    view.camera.focal = of.focal;
    view.camera.principal_point = of.principal_point;
    view.camera.skew = of.skew;
    const Comparison items = compare(world, view, Oracle::brute, 2);
    EXPECT_EQ(items.agree, items.pixels);
    Renderer renderer(1);
    Film film;
    Settings settings;
    settings.aovs = {Aov::item};
    renderer.render(world, view, settings, film);
    EXPECT_GT(std::count_if(film.item.begin(), film.item.end(),
                  [](std::uint32_t item) { return item != kNoItem; }),
        4000);
}

TEST(CalibratedCamera, PlanesAreOfTheTextbooksRays)
{
    CameraPicture picture;
    for (const Intrinsics& of : intrinsics()) {
        SCOPED_TRACE(of.principal_point.x);
        picture.use(of);
        const Film film = picture.render();
        const glm::dmat3 world_to_frame = glm::transpose(picture.axes());
        std::size_t hits = 0;
        for (std::size_t k = 0; k < film.item.size(); ++k) {
            if (film.item[k] == kNoItem) continue;
            ++hits;
            const int i = int(k % 96), j = int(k / 96);
            const double depth = double(film[Aov::depth].value[k]);
            const glm::dvec3 from_eye = vector_at(film[Aov::position], k) - picture.view.camera.eye;
            // Project back to the pixel's middle. Coordinates are floats of up to 40.
            const glm::dvec3 p = world_to_frame * from_eye;
            const double tolerance = 2e-5 / depth * std::max(of.focal.x, of.focal.y) + 1e-4;
            EXPECT_NEAR(of.focal.x * p.x / p.z + of.skew * p.y / p.z + of.principal_point.x,
                i + 0.5, tolerance);
            EXPECT_NEAR(of.focal.y * p.y / p.z + of.principal_point.y, j + 0.5, tolerance);
            EXPECT_NEAR(p.z / depth, 1, 1e-5);
            const glm::dvec3 d = picture.ray(i, j);
            EXPECT_NEAR(double(film[Aov::distance].value[k]) / (depth * glm::length(d)), 1, 1e-6);
            for (const Aov aov : {Aov::normal, Aov::geometric_normal}) {
                const glm::dvec3 n = vector_at(film[aov], k);
                EXPECT_NEAR(glm::length(n), 1, 1e-5);
                EXPECT_LE(glm::dot(n, d), 1e-4 * glm::length(d));
            }
        }
        EXPECT_GT(hits, 600u);
    }
}

/// The nearest triangle along a ray in world space, in double.
std::uint32_t nearest(const World& world, const glm::dvec3& eye, const glm::dvec3& d)
{
    std::uint32_t best = kNoItem;
    double least = std::numeric_limits<double>::infinity();
    const auto& index = world.scene->index;
    for (std::uint32_t id = 0; id < index.size(); ++id) {
        const glm::dvec3 p0(world.position[index[id].x]);
        const glm::dvec3 e1 = glm::dvec3(world.position[index[id].y]) - p0,
                         e2 = glm::dvec3(world.position[index[id].z]) - p0;
        const glm::dvec3 n = glm::cross(e1, e2), from = p0 - eye;
        const double det = glm::dot(n, d), t = glm::dot(n, from) / det,
                     u = glm::dot(glm::cross(e2, from), d) / det,
                     v = glm::dot(glm::cross(from, e1), d) / det;
        if (u >= 0 && v >= 0 && u + v <= 1 && t > 0 && t < least) best = id, least = t;
    }
    return best;
}

TEST(CalibratedCamera, SeesTheTrianglesOfTheTextbooksRays)
{
    CameraPicture picture;
    picture.settings.color = false;
    picture.settings.aovs = {Aov::item};
    for (const Intrinsics& of : intrinsics()) {
        SCOPED_TRACE(of.principal_point.x);
        picture.use(of);
        const Film film = picture.render();
        int different = 0, asked = 0;
        for (int j = 0; j < 64; j += 3)
            for (int i = j % 2; i < 96; i += 5, ++asked)
                different += film.item[std::size_t(j * 96 + i)] !=
                             nearest(picture.world, picture.view.camera.eye, picture.ray(i, j));
        EXPECT_LE(different, asked / 200) << "only rays that graze an edge may differ";
    }
}

TEST(CalibratedCamera, MovedByWholePixelsSeesARegionOfTheLargerPicture)
{
    for (const Shadows shadows : {Shadows::exact, Shadows::map}) {
        CameraPicture picture;
        picture.settings.shadows = shadows;
        picture.view.camera.focal = glm::dvec2(120.3, 130.9);
        picture.view.width = 192, picture.view.height = 160;
        picture.view.region = {37, 61, 96, 64};
        const Film expected = picture.render();
        picture.view.width = 96, picture.view.height = 64;
        picture.view.region = {};
        picture.view.camera.principal_point = glm::dvec2(96 - 37, 80 - 61);
        expect_equal(picture.render(), expected);
    }
}

TEST(CalibratedCamera, OfOneFocalLengthInTheMiddleIsThatOfTheFieldOfView)
{
    CameraPicture picture;
    const Film expected = picture.render();
    const double f = 32 / std::tan(0.5 * picture.view.camera.fov_y_rad);
    picture.use({glm::dvec2(f), {48, 32}, 0});
    expect_equal(picture.render(), expected);
    picture.view.camera.principal_point.reset();
    expect_equal(picture.render(), expected);
}

TEST(CalibratedCamera, MakesTheSameBitsWithAnyThreadsTilesAndRegions)
{
    CameraPicture picture;
    picture.use(intrinsics()[2]);
    const Film expected = picture.render();
    picture.settings.tile_size = 24;
    expect_equal(picture.render(3), expected);
    picture.view.region = {11, 7, 50, 40};
    const Film region = picture.render();
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 50; ++x)
            EXPECT_EQ(region.item[std::size_t(y * 50 + x)],
                expected.item[std::size_t((y + 7) * 96 + x + 11)]);
}

TEST(CalibratedCamera, OfSeveralSamplesIsALargerPicturesAverage)
{
    constexpr int kSamples = 3;
    CameraPicture picture;
    picture.settings.aovs.clear();
    const Intrinsics of = intrinsics()[2];
    picture.use(of);
    picture.settings.samples = kSamples;
    const Film film = picture.render();
    picture.use(
        {of.focal * double(kSamples), of.principal_point * double(kSamples), of.skew * kSamples});
    picture.view.width *= kSamples, picture.view.height *= kSamples;
    picture.settings.samples = 1;
    const Film fine = picture.render();
    for (int y = 0; y < film.height; ++y) {
        for (int x = 0; x < film.width * 3; ++x) {
            float sum = 0;
            for (int sy = 0; sy < kSamples; ++sy)
                for (int sx = 0; sx < kSamples; ++sx)
                    sum += fine.color.value[std::size_t((y * kSamples + sy) * fine.width +
                                                        x / 3 * kSamples + sx) *
                                                3 +
                                            std::size_t(x % 3)];
            EXPECT_NEAR(film.color.value[std::size_t(y * film.width * 3 + x)],
                sum / float(kSamples * kSamples), 1e-6f);
        }
    }
}

TEST(CalibratedCamera, HasTheMapsShadowsWhereTheExactOnesAre)
{
    CameraPicture picture;
    picture.settings.color = false;
    picture.settings.aovs = {Aov::lit};
    for (const Intrinsics& of : intrinsics()) {
        SCOPED_TRACE(of.principal_point.x);
        picture.use(of);
        picture.settings.shadows = Shadows::exact;
        const Film exact = picture.render();
        picture.settings.shadows = Shadows::map;
        const Film map = picture.render();
        const std::vector<float>&a = exact[Aov::lit].value, &b = map[Aov::lit].value;
        ASSERT_EQ(a.size(), b.size());
        std::size_t different = 0;
        for (std::size_t k = 0; k < a.size(); ++k) different += a[k] != b[k];
        EXPECT_LT(double(different), 0.03 * double(a.size()));
        EXPECT_GT(std::count(a.begin(), a.end(), 0.0f), 100);
        EXPECT_GT(std::count(a.begin(), a.end(), 1.0f), 100);
    }
}

} // namespace
} // namespace firsthit::test
