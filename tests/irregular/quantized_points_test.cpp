// quantized_points_test.cpp - the worked example of irregular/grid/quantized_points.h, number by number,
// on every instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "irregular/quantized_points_test.cpp"
#include "base/simd.h"

#include "instruction_sets.h"
#include "irregular/grid/grid_boxes-inl.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#ifndef FIRSTHIT_TESTS_IRREGULAR_QUANTIZED_POINTS_TEST_ // seen once, unlike the code of each target
#define FIRSTHIT_TESTS_IRREGULAR_QUANTIZED_POINTS_TEST_
namespace firsthit::test {

inline constexpr std::size_t kSamples = 4;

/// Words of QuantizedPoint.
struct Triangle {
    std::uint64_t corner[3];
};

/// What the grid computes of a triangle and of samples.
struct TriangleTest {
    std::uint64_t low, high, normal[3], beyond, beyond_opposite;
    bool in_box[kSamples], outside[kSamples];
    std::int32_t edge[kSamples][3];
};

} // namespace firsthit::test
#endif

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

void test_triangle(const test::Triangle& triangle, const SampleGrid& grid,
    const std::uint64_t (&samples)[test::kSamples], test::TriangleTest& result)
{
    const Words d;
    const Word a = hn::Set(d, triangle.corner[0]), b = hn::Set(d, triangle.corner[1]),
               c = hn::Set(d, triangle.corner[2]);
    const Word low = hn::And(least16(least16(a, b), c), hn::Set(d, kUpperHalf)),
               high = greatest16(greatest16(a, b), c);
    result.low = hn::GetLane(low);
    result.high = hn::GetLane(high);
    const GridEdges edges = find_edges(grid, {a, b, c}, low, high);
    for (int e = 0; e < 3; ++e) result.normal[e] = hn::GetLane(edges.normal[e]);
    result.beyond = hn::GetLane(edges.beyond);
    result.beyond_opposite = hn::GetLane(edges.beyond_opposite);
    for (std::size_t k = 0; k < test::kSamples; ++k) {
        const Word sample = hn::Set(d, samples[k]), from = difference16(sample, a);
        const Word clamped = greatest16(least16(sample, high), low);
        result.in_box[k] = hn::GetLane(clamped) == samples[k];
        result.outside[k] = bits_of_words(edges.outside(from)) & 1;
        for (int e = 0; e < 3; ++e) {
            const Word value = hn::Add(
                products16(from, edges.normal[e]), e == 1 ? edges.beyond_opposite : edges.beyond);
            result.edge[k][e] = std::int32_t(hn::GetLane(value) >> 32);
        }
    }
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(test_triangle);

namespace test {
namespace {

/// The points are the samples.
struct UnusedPoints : PencilPoints {
    glm::vec3 in_pencil_space(std::uint32_t) const override { return glm::vec3(0); }
};

constexpr std::uint64_t kA = 0x0041004100000101, kB = 0x0041014100000101, kC = 0x0101004100000081;
constexpr std::uint64_t kP = 0x0081008100000041, kQ = 0x0101010100000041, kR = 0x0081008100000201;

/// The grid of the example: the samples p, q, r and two at the ends of the bounds.
void make_grid(const std::vector<IrregularSample>& samples, SampleGrid& grid)
{
    const float end = 65533.0f / 64;
    const SampleBounds bounds{0, 0, end, end, 0, end};
    const SamplePatch patch{{0, samples.size()}, bounds};
    Tasks tasks(1);
    ASSERT_TRUE(sort_into_grid(
        {samples, {&patch, 1}, bounds}, {.directional = true}, UnusedPoints(), grid, tasks));
}

TEST(QuantizedPoints, AreAsInTheWorkedExample)
{
    const float end = 65533.0f / 64;
    const std::vector<IrregularSample> samples{
        {2, 2, 1, 0}, {4, 4, 1, 1}, {2, 2, 8, 2}, {0, 0, 0, 3}, {end, end, end, 4}};
    // A parallel pencil has w = -c.
    const std::vector<glm::vec3> corners{{1, 1, -4}, {5, 1, -4}, {1, 4, -2}, {-1, 2000, -3}};
    for_instruction_sets([&] {
        SampleGrid grid;
        make_grid(samples, grid);
        for (const GridAxes::Axis& axis : {grid.axes.x, grid.axes.y, grid.axes.w}) {
            EXPECT_EQ(axis.start, 0);
            EXPECT_EQ(axis.scale, 64);
        }
        EXPECT_EQ(grid.error_shift, 0);
        EXPECT_EQ(grid.error_rest, 4u);

        std::vector<std::uint64_t> sorted(samples.size());
        for (std::size_t k = 0; k < samples.size(); ++k)
            sorted[grid.sample_index[k]] = grid.quantized[k];
        const std::vector<std::uint64_t> expected{
            kP, kQ, kR, 0x0001000100000001, 0xFFFEFFFE0000FFFE};
        EXPECT_EQ(sorted, expected);

        std::vector<QuantizedPoint> quantized(corners.size());
        quantize_vertices(
            grid.axes, cube_face(true, 0), corners.data(), corners.size(), quantized.data());
        std::vector<std::uint64_t> words(corners.size());
        std::memcpy(words.data(), quantized.data(), 8 * words.size());
        // The last corner is below all samples in x and above all in y.
        EXPECT_EQ(words, (std::vector<std::uint64_t>{kA, kB, kC, 0xFFFF0000000000C1}));
    });
}

TEST(QuantizedPoints, AreTestedAsInTheWorkedExample)
{
    const std::vector<IrregularSample> samples{{2, 2, 1, 0}};
    // The last word is the one of spare entries: `unused` is 1.
    const std::uint64_t words[kSamples] = {kP, kQ, kR, kP | 1u << 16};
    const bool flipped[] = {false, true};
    for (const bool flip : flipped) {
        // In the other order of corners all normals are negated: the same tests.
        const Triangle triangle = flip ? Triangle{{kA, kC, kB}} : Triangle{{kA, kB, kC}};
        for_instruction_sets([&] {
            SampleGrid grid;
            make_grid(samples, grid);
            TriangleTest result;
            HWY_DYNAMIC_DISPATCH(test_triangle)(triangle, grid, words, result);
            EXPECT_EQ(result.low, 0x0041004100000000u);
            EXPECT_EQ(result.high, 0x0101014100000101u);
            const int ab = flip ? 2 : 0, bc = 1, ca = flip ? 0 : 2;
            EXPECT_EQ(result.normal[ab], 0x0100000000000000u); // (0, 256)
            EXPECT_EQ(result.normal[bc], 0xFF00FF4000000000u); // (-192, -256)
            EXPECT_EQ(result.normal[ca], 0x000000C000000000u); // (192, 0)
            EXPECT_EQ(result.beyond, std::uint64_t(1125) << 32);
            EXPECT_EQ(result.beyond_opposite, std::uint64_t(1125 + 49152) << 32);
            const bool in_box[kSamples] = {true, true, false, false};
            for (std::size_t k = 0; k < kSamples; ++k) EXPECT_EQ(result.in_box[k], in_box[k]) << k;
            EXPECT_FALSE(result.outside[0]);
            EXPECT_TRUE(result.outside[1]);
            const auto &p = result.edge[0], &q = result.edge[1];
            EXPECT_EQ(p[ab], 17509);
            EXPECT_EQ(p[bc], 21605);
            EXPECT_EQ(p[ca], 13413);
            EXPECT_EQ(q[ab], 50277);
            EXPECT_EQ(q[bc], -35739);
            EXPECT_EQ(q[ca], 37989);
        });
    }
}

} // namespace
} // namespace test
} // namespace firsthit
#endif
