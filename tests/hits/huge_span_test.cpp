// huge_span_test.cpp - hits of triangles that span many octaves, or have the eye next to their plane, against
// whole numbers.
#include "../exact/big_integer.h"
#include "exact/careful_hit.h"
#include "hits/resolve_tile.h"
#include "instruction_sets.h"

#include <firsthit/scene.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <functional>
#include <random>
#include <vector>

namespace firsthit::test {
namespace {

BigInteger whole(float x)
{
    return BigInteger::of_float(x);
}

/// d . (a x b), three times scaled by 2^149.
BigInteger volume_of(const glm::vec3& d, const glm::vec3& a, const glm::vec3& b)
{
    return whole(d.x) * (whole(a.y) * whole(b.z) - whole(a.z) * whole(b.y)) +
           whole(d.y) * (whole(a.z) * whole(b.x) - whole(a.x) * whole(b.z)) +
           whole(d.z) * (whole(a.x) * whole(b.y) - whole(a.y) * whole(b.x));
}

/// A hit as fractions of whole numbers.
struct ExactHit {
    BigInteger det, volume, edge1, edge2;

    ExactHit(const Corners& c, const glm::vec3& d)
        : volume(volume_of(c[0], c[1], c[2])),
          edge1(volume_of(d, c[2], c[0])),
          edge2(volume_of(d, c[0], c[1]))
    {
        det = volume_of(d, c[1], c[2]) + edge1 + edge2;
    }

    /// The sign of x - numerator / det.
    int compare(float x, const BigInteger& numerator) const
    {
        return (whole(x) * det - numerator * whole(1)).sign() * det.sign();
    }

    bool is_within(float low, const BigInteger& numerator, float high) const
    {
        return compare(low, numerator) <= 0 && compare(high, numerator) >= 0;
    }
};

/// One block of samples whose first ray is (x0, y0, 1), and their triangles in eye space.
struct Block {
    EyeMesh mesh;
    TileItems items;
    HitMemory memory;
    HitTile hits;
    std::vector<Corners> triangles;
    std::vector<glm::uvec3> index;

    Block(std::vector<Corners> given, const std::array<std::uint32_t, kBlockSamples>& item,
        glm::vec2 first)
        : triangles(std::move(given))
    {
        mesh.corner.resize(3 * triangles.size());
        for (std::uint32_t i = 0; i < triangles.size(); ++i) {
            index.push_back(glm::uvec3(0, 1, 2) + 3 * i);
            for (std::uint32_t k = 0; k < 3; ++k)
                mesh.corner.data()[3 * i + k] = glm::vec4(triangles[i][k], 1);
        }
        mesh.index = index;
        resize(items, kBlock);
        items.rays = {first.x, first.y};
        std::copy(item.begin(), item.end(), items.item.data());
        resize(memory, kBlock, 1);
        hits = resolve_tile(mesh, Pencil(), items, memory.of(0));
    }
};

using RandomTriangle = std::function<Corners(const glm::vec3& d, std::mt19937& random)>;

/// Sizes of numbers, equally many of each octave.
float size_between(float least, float most, std::mt19937& random)
{
    return std::exp(std::uniform_real_distribution<float>(std::log(least), std::log(most))(random));
}

/// Around the ray as the eye sees it, each corner at a distance of its own.
Corners far_and_near(const glm::vec3& d, std::mt19937& random)
{
    std::uniform_real_distribution<float> turn(0, 2.0f), radius(15, 200);
    Corners c;
    for (std::size_t k = 0; k < 3; ++k) {
        const float angle = 2.1f * float(k) + turn(random), r = radius(random);
        c[k] = glm::vec3(d.x + r * std::cos(angle), d.y + r * std::sin(angle), 1) *
               size_between(1e-3f, 1e12f, random);
    }
    return c;
}

/// The same, some corners behind the eye.
Corners around_the_eye(const glm::vec3& d, std::mt19937& random)
{
    Corners c = far_and_near(d, random);
    for (glm::vec3& p : c)
        if (random() % 3 == 0) p = -p;
    return c;
}

/// One corner far away, the others next to each other: far.py's.
Corners one_far(const glm::vec3& d, std::mt19937& random)
{
    std::uniform_real_distribution<float> any(-30, 30);
    Corners c;
    const std::size_t far = random() % 3;
    for (std::size_t k = 0; k < 3; ++k)
        c[k] = glm::vec3(d.x + any(random), d.y + any(random), random() % 4 == 0 ? -1 : 1) *
               size_between(1e-3f, 0.1f, random);
    c[far] = glm::vec3(d.x + any(random), d.y + any(random), random() % 2 == 0 ? -1 : 1) *
             size_between(1e9f, 1e12f, random);
    return c;
}

/// A floor of a million kilometres, the eye next to it.
Corners wide_floor(const glm::vec3& d, std::mt19937& random)
{
    std::uniform_real_distribution<float> any(-1e9f, 1e9f), slope(-1e-3f, 1e-3f);
    const float height = size_between(1e-4f, 1e3f, random) * (d.y > 0 ? 1.0f : -1.0f),
                sx = slope(random), sz = slope(random);
    Corners c;
    for (glm::vec3& p : c) {
        p.x = any(random) * 100;
        p.z = any(random);
        p.y = height + sx * p.x + sz * p.z;
    }
    return c;
}

/// A sliver of nearly no area.
Corners sliver(const glm::vec3& d, std::mt19937& random)
{
    std::uniform_real_distribution<float> any(-1, 1);
    const glm::vec3 p = d * 1000.0f,
                    along = glm::vec3(any(random), any(random), any(random)) * 3000.0f;
    const auto jitter = [&] { return glm::vec3(any(random), any(random), any(random)) * 1e-3f; };
    return {p - along + jitter(), p + along + jitter(), p + along * 0.3f + jitter()};
}

bool is_hit_by_all(const Corners& c, const std::vector<glm::vec3>& rays)
{
    Effort effort;
    return std::all_of(
        rays.begin(), rays.end(), [&](const glm::vec3& d) { return is_hit(c, d, effort); });
}

/// A block with so many triangles, each hit by the rays of all samples that it is given to.
Block block_of(std::size_t count, const RandomTriangle& make, std::mt19937& random)
{
    std::uniform_int_distribution<int> place(-2000, 2000);
    const glm::vec2 first(float(place(random)) / 2, float(place(random)) / 2);
    std::array<std::uint32_t, kBlockSamples> item;
    item.fill(kNoItem);
    std::vector<Corners> triangles;
    for (std::size_t i = 0; i < count; ++i) {
        // Only one sample where no triangle is found that all rays hit.
        std::vector<int> samples;
        for (std::size_t k = i; k < kBlockSamples; k += count) samples.push_back(int(k));
        Corners c;
        for (int tries = 0;; ++tries) {
            if (tries == 100) samples.resize(1);
            std::vector<glm::vec3> rays;
            for (const int k : samples)
                rays.push_back({first.x + float(block_x(k)), first.y + float(block_y(k)), 1});
            c = make(rays[rays.size() / 2], random);
            if (tries % 2) std::swap(c[1], c[2]);
            if (is_hit_by_all(c, rays)) break;
        }
        for (const int k : samples) item[std::size_t(k)] = std::uint32_t(i);
        triangles.push_back(c);
    }
    return Block(triangles, item, first);
}

struct Case {
    const char* name;
    RandomTriangle make;
};

const std::vector<Case>& cases()
{
    static const std::vector<Case> all = {{"far and near", far_and_near},
        {"around the eye", around_the_eye}, {"one far", one_far}, {"wide floor", wide_floor},
        {"sliver", sliver}};
    return all;
}

void check_block(const Block& block, int& worse_than_plain)
{
    const HitTile& hits = block.hits;
    Effort effort;
    for (const HitRun& run : hits.runs) {
        const Corners& c = block.triangles[run.item];
        ASSERT_EQ(run.eye_side, volume_sign(c, effort));
        for (std::uint64_t rest = run.samples; rest; rest &= rest - 1) {
            const int k = std::countr_zero(rest);
            const glm::vec3 d = block.items.rays.direction(block_x(k), block_y(k));
            const ExactHit exact(c, d);
            const float t = hits.t[k], u = hits.u[k], v = hits.v[k];
            ASSERT_TRUE(
                exact.is_within(std::nextafter(t, 0.0f), exact.volume, std::nextafter(t, INFINITY)))
                << t << " or " << CarefulHit(c).depth(d);
            const auto weight = [&](float w, const BigInteger& edge) {
                return exact.is_within(
                    std::nextafter(w - 0x1p-24f, -1.0f), edge, std::nextafter(w + 0x1p-24f, 2.0f));
            };
            ASSERT_TRUE(weight(u, exact.edge1)) << u;
            ASSERT_TRUE(weight(v, exact.edge2)) << v;
            const CarefulHit::Plain plain = CarefulHit(c).plain(d);
            worse_than_plain += !plain.depth || !plain.weights;
        }
    }
}

TEST(HugeSpan, DepthIsWithinOneUnitInTheLastPlaceHoweverManyTrianglesABlockSees)
{
    for (const Case& kind : cases()) {
        SCOPED_TRACE(kind.name);
        int worse_than_plain = 0;
        for (const std::size_t count : {1, 2, 3, 5, 8, 13, 16, 17, 32, 64}) {
            SCOPED_TRACE(count);
            std::mt19937 random(7);
            for (int round = 0; round < 4; ++round) {
                const Block block = block_of(count, kind.make, random);
                check_block(block, worse_than_plain);
                if (HasFatalFailure()) return;
            }
        }
        EXPECT_GT(worse_than_plain, 10); // it was worth asking
    }
}

TEST(HugeSpan, HitsHaveTheSameBitsOnEveryInstructionSet)
{
    for (const Case& kind : cases()) {
        SCOPED_TRACE(kind.name);
        for (const std::size_t count : {1, 5, 16, 64}) {
            std::mt19937 best_random(3);
            const Block best = block_of(count, kind.make, best_random);
            for_instruction_sets([&] {
                std::mt19937 random(3);
                const Block other = block_of(count, kind.make, random);
                const auto same = [](const float* a, const float* b) {
                    return std::memcmp(a, b, kBlockSamples * sizeof(float)) == 0;
                };
                ASSERT_TRUE(same(best.hits.t, other.hits.t) && same(best.hits.u, other.hits.u) &&
                            same(best.hits.v, other.hits.v));
                for (std::size_t i = 0; i < best.hits.runs.size(); ++i) {
                    ASSERT_EQ(best.hits.runs[i].eye_side, other.hits.runs[i].eye_side);
                    ASSERT_EQ(best.hits.runs[i].plane, other.hits.runs[i].plane);
                }
            });
        }
    }
}

TEST(HugeSpan, ATrianglesBitsDoNotDependOnTheOthersInItsBlock)
{
    // Alone, its block is resolved run by run; among others, sample by sample.
    for (const Case& kind : cases()) {
        SCOPED_TRACE(kind.name);
        std::mt19937 random(11);
        for (const std::size_t count : {4, 12, 40}) {
            const Block many = block_of(count, kind.make, random);
            for (const HitRun& run : many.hits.runs) {
                std::array<std::uint32_t, kBlockSamples> item;
                for (int k = 0; k < kBlockSamples; ++k)
                    item[std::size_t(k)] = run.samples >> k & 1 ? run.item : kNoItem;
                const Block alone(many.triangles, item, {many.items.rays.x0, many.items.rays.y0});
                ASSERT_EQ(alone.hits.runs.size(), 1u);
                EXPECT_EQ(alone.hits.runs[0].eye_side, run.eye_side);
                EXPECT_EQ(alone.hits.runs[0].plane, run.plane);
                for (std::uint64_t rest = run.samples; rest; rest &= rest - 1) {
                    const int k = std::countr_zero(rest);
                    EXPECT_EQ(alone.hits.t[k], many.hits.t[k]);
                    EXPECT_EQ(alone.hits.u[k], many.hits.u[k]);
                    EXPECT_EQ(alone.hits.v[k], many.hits.v[k]);
                }
            }
        }
    }
}

} // namespace
} // namespace firsthit::test
