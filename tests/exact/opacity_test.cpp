// opacity_test.cpp - opacity against an evaluation of its own, and the weights that it is asked at
// against whole numbers of any size.
#include "exact/opacity.h"

#include "exact/cutouts.h"
#include "exact/hit.h"

#include "cutouts.h"
#include "exact/big_integer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace firsthit::test {
namespace {

using glm::vec3;

/// Texture coordinates are first moved into [0, 1], as the wrap modes say.
long double into_unit(long double x, Wrap wrap)
{
    if (wrap == Wrap::clamp) return x; // texels are clamped
    if (wrap == Wrap::repeat) return x - std::floor(x);
    const long double twice = x - 2 * std::floor(x / 2);
    return twice <= 1 ? twice : 2 - twice;
}

int neighbour(int k, int n, Wrap wrap)
{
    if (wrap == Wrap::repeat) return (k + n) % n;
    return std::min(std::max(k, 0), n - 1); // the mirrored neighbour of a border is the border
}

long double sampled(const Texture& texture, long double s, long double t)
{
    const Sampler& sampler = texture.sampler();
    const int width = texture.width(), height = texture.height();
    const long double x = into_unit(s, sampler.wrap_u) * width;
    const long double y = (1 - into_unit(t, sampler.wrap_v)) * height;
    const auto texel = [&](long double column, long double row) {
        const auto whole = [](long double k) { return int(std::min(std::max(k, -2.0L), 1e6L)); };
        return (long double)(texture
                                 .color(0, neighbour(whole(column), width, sampler.wrap_u),
                                     neighbour(whole(row), height, sampler.wrap_v))
                                 .a);
    };
    if (sampler.nearest) return texel(std::floor(x), std::floor(y));
    const long double left = std::floor(x - 0.5L), top = std::floor(y - 0.5L);
    const long double fx = x - 0.5L - left, fy = y - 0.5L - top;
    return (1 - fx) * (1 - fy) * texel(left, top) + fx * (1 - fy) * texel(left + 1, top) +
           (1 - fx) * fy * texel(left, top + 1) + fx * fy * texel(left + 1, top + 1);
}

long double expected_opacity(const Scene& scene, std::uint32_t triangle, float u, float v)
{
    const glm::uvec3& c = scene.index[triangle];
    const long double weight[3] = {1.0L - u - v, u, v};
    const Material& material = scene.materials[scene.instances[scene.owner[triangle]].material];
    long double vertex = scene.color.empty() ? 1 : 0, s = 0, t = 0;
    const auto& uv = material.opacity_texture.uv_set ? scene.uv1 : scene.uv;
    for (int k = 0; k < 3; ++k) {
        if (!scene.color.empty()) vertex += weight[k] * scene.color[c[k]].a;
        s += weight[k] * uv[c[k]].x, t += weight[k] * uv[c[k]].y;
    }
    long double alpha = vertex * material.opacity;
    if (material.opacity_texture.texture < 0) return alpha;
    const glm::mat3x2& m = material.opacity_texture.transform;
    return alpha * sampled(scene.textures[std::size_t(material.opacity_texture.texture)],
                       m[0].x * s + m[1].x * t + m[2].x, m[0].y * s + m[1].y * t + m[2].y);
}

TEST(Opacity, EqualsItsFormula)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(0, 1);
    std::size_t compared = 0, apart = 0;
    for (int round = 0; round < 60; ++round) {
        TestWorld world;
        for (int k = 0; k < 40; ++k) world.add({0, 0, 1}, {1, 0, 1}, {0, 1, 1});
        world.finish();
        make_cutouts(world, random, round % 2 == 0);
        const Scene& scene = *world.scene;
        for (std::uint32_t t = 0; t < scene.index.size(); ++t) {
            for (int k = 0; k < 20; ++k) {
                float u = unit(random), v = unit(random);
                if (u + v > 1) u = 1 - u, v = 1 - v;
                if (k == 0) u = v = 0;
                const long double expected = expected_opacity(scene, t, u, v);
                const float found = opacity(scene, t, u, v);
                ++compared;
                // Coordinates far out leave double fewer digits, and a nearest texel may be the next
                // one where its border is met to the last digit.
                apart += std::abs(double(found) - double(expected)) > 1e-5;
            }
        }
    }
    EXPECT_EQ(compared, 60u * 40u * 20u);
    EXPECT_LT(apart, compared / 5000) << "of " << compared;
}

/// One triangle whose material has this texture; the weights of a point are its texture coordinates.
struct Square {
    TestWorld world;

    explicit Square(Texture texture, Sampler sampler)
    {
        world.add({0, 0, 1}, {1, 0, 1}, {0, 1, 1});
        world.finish();
        Scene& scene = *world.scene;
        texture.set_sampler(sampler);
        scene.textures = {std::move(texture)};
        scene.uv = {{0, 0}, {1, 0}, {0, 1}};
        scene.materials[0].alpha = AlphaMode::mask;
        scene.materials[0].opacity_texture.texture = 0;
    }

    float at(float s, float t)
    {
        // From the origin of the texture, so that all coordinates can be asked.
        Scene& scene = *world.scene;
        scene.materials[0].opacity_texture.transform = glm::mat3x2(1, 0, 0, 1, s, t);
        return opacity(scene, 0, 0, 0);
    }
};

TEST(Opacity, OfAConstantIsThatConstant)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(0, 1);
    Square square(alpha_texture(3, 2, {255, 255, 255, 255, 255, 255}), {});
    square.world.scene->color.assign(3, glm::vec4(1));
    for (int k = 0; k < 2000; ++k) {
        const float u = unit(random), v = unit(random) * (1 - u);
        ASSERT_EQ(opacity(*square.world.scene, 0, u, v), 1.0f); // so a cutoff of 1 lets nothing out
    }
}

TEST(Opacity, WrapsAsTheSamplerSays)
{
    const Texture texture = alpha_texture(2, 2, {0, 85, 170, 255}); // top row first
    const auto alpha = [](int code) { return float(std::lround(code / 255.0 * 32768)) / 32768; };
    Square repeat(texture, {Wrap::repeat, Wrap::repeat, true});
    EXPECT_EQ(repeat.at(0.25f, 0.75f), alpha(0));
    EXPECT_EQ(repeat.at(0.75f, 0.75f), alpha(85));
    EXPECT_EQ(repeat.at(0.25f, 0.25f), alpha(170));
    EXPECT_EQ(repeat.at(-0.25f, 5.25f), alpha(255));
    EXPECT_EQ(repeat.at(1e6f + 0.25f, -1e5f + 0.75f), alpha(0));
    Square mirror(texture, {Wrap::mirror, Wrap::mirror, true});
    EXPECT_EQ(mirror.at(-0.25f, 0.25f), alpha(170));
    EXPECT_EQ(mirror.at(1.25f, 1.25f), alpha(85));
    EXPECT_EQ(mirror.at(2.25f, -1.25f), alpha(0));
    Square clamp(texture, {Wrap::clamp, Wrap::clamp, true});
    EXPECT_EQ(clamp.at(-7, -3e30f), alpha(170));
    EXPECT_EQ(clamp.at(1.25f, 9), alpha(85));
    // Bilinear: at a texel's middle its own alpha; between two in the middle their mean.
    Square soft(texture, {Wrap::repeat, Wrap::clamp, false});
    EXPECT_EQ(soft.at(0.25f, 0.75f), alpha(0));
    EXPECT_EQ(soft.at(0.5f, 0.75f), 0.5f * alpha(85));
    EXPECT_EQ(soft.at(0.0f, 0.75f), 0.5f * alpha(85)); // across the border
    EXPECT_EQ(soft.at(0.25f, 2), alpha(0));            // not across it
}

TEST(Opacity, CountsThreeFactors)
{
    Square square(alpha_texture(1, 1, {255}), {});
    Scene& scene = *square.world.scene;
    scene.color = {glm::vec4(1, 1, 1, 0.5f), glm::vec4(1, 1, 1, 0.5f), glm::vec4(1, 1, 1, 1)};
    scene.materials[0].opacity = 0.5f;
    EXPECT_EQ(opacity(scene, 0, 0.25f, 0.5f), 0.375f);
    scene.materials[0].opacity = 0;
    EXPECT_EQ(opacity(scene, 0, 0.25f, 0.5f), 0.0f);
}

TEST(Cutouts, AreTheTrianglesThatMayHaveHoles)
{
    Square square(alpha_texture(1, 1, {255}), {});
    Scene& scene = *square.world.scene;
    Cutouts cutouts;
    const auto has = [&] {
        cutouts.find(scene, kShadowOpacity);
        EXPECT_EQ(cutouts.any(), cutouts.has(0));
        EXPECT_EQ(cutouts.any(), has_cutouts(scene));
        return cutouts.has(0);
    };
    EXPECT_TRUE(has()); // it has a texture
    EXPECT_FALSE(has_blended_triangles(scene));
    scene.materials[0].opacity_texture.texture = -1;
    EXPECT_FALSE(has());
    scene.materials[0].alpha_cutoff = 1.5f;
    EXPECT_TRUE(has()); // it is nowhere
    scene.materials[0].alpha = AlphaMode::blend;
    EXPECT_TRUE(has_blended_triangles(scene));
    EXPECT_FALSE(has());
    scene.materials[0].opacity = 0.4f;
    EXPECT_TRUE(has());
    cutouts.find(scene, kSeenOpacity);
    EXPECT_FALSE(cutouts.any()); // it is seen everywhere
    scene.materials[0].alpha = AlphaMode::opaque;
    EXPECT_FALSE(has());
}

using Big = BigInteger;

/// d . (a x b)
Big edge(const vec3& a, const vec3& b, const vec3& d)
{
    Big sum;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const auto product = [&](float p, float q) { return Big::of_float(p) * Big::of_float(q); };
        sum = sum + Big::of_float(d[i]) * (product(a[j], b[k]) - product(a[k], b[j]));
    }
    return sum;
}

/// The sign of edge / det - value.
int above(const Big& edge, const Big& det, float value)
{
    return (edge * Big::of_float(1) - det * Big::of_float(value)).sign() * det.sign();
}

/// Whether no float is nearer to edge / det than this one.
bool is_nearest(const Big& edge, const Big& det, float value)
{
    const Big two = Big::of_float(2), one = Big::of_float(1);
    const auto side_of_middle = [&](float other) { // of edge / det, of the middle to the other
        const Big middle = Big::of_float(value) + Big::of_float(other); // times 2
        return (edge * two * one - det * middle * one).sign() * det.sign();
    };
    if (above(edge, det, value) == 0) return true;
    const float infinity = std::numeric_limits<float>::infinity();
    return side_of_middle(std::nextafter(value, infinity)) <= 0 &&
           side_of_middle(std::nextafter(value, -infinity)) >= 0;
}

TEST(RoundedBarycentrics, AreTheNearestFloats)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(0, 1);
    std::size_t hits = 0;
    for (int k = 0; k < 40000; ++k) {
        // Ordinary, far and small, thin, and with corners on a coarse grid, where weights are 0, 1
        // and halves of neighbouring floats.
        const int kind = k % 4;
        const float size = kind == 1 ? 1e-3f : 1.0f, far = kind == 1 ? 100.0f : 3.0f;
        const auto corner = [&](float bend) {
            vec3 p(size * (unit(random) - 0.5f), size * (unit(random) - 0.5f),
                far + size * unit(random));
            if (kind == 2) p.y = p.x * 0.5f + 1e-5f * bend;
            if (kind == 3) p = vec3(float(int(random() % 5)) - 2, float(int(random() % 5)) - 2, 2);
            return p;
        };
        const Corners c{corner(0), corner(1), corner(-1)};
        // Through a point of it, rounded.
        float a = unit(random), b = unit(random);
        if (kind == 3) a = float(random() % 3) * 0.5f, b = float(random() % 3) * 0.5f;
        if (a + b > 1) a = 1 - a, b = 1 - b;
        const vec3 d = c[0] * (1 - a - b) + c[1] * a + c[2] * b;
        Effort effort;
        if (!is_hit(c, d, effort)) continue;
        ++hits;
        const Big det = edge(c[0], c[1], d) + edge(c[1], c[2], d) + edge(c[2], c[0], d);
        const auto [u, v] = rounded_barycentrics(c, d);
        ASSERT_TRUE(is_nearest(edge(c[2], c[0], d), det, u)) << k << ": " << u;
        ASSERT_TRUE(is_nearest(edge(c[0], c[1], d), det, v)) << k << ": " << v;
    }
    EXPECT_GT(hits, 20000u);
}

} // namespace
} // namespace firsthit::test
