// rounding_test.cpp - the compiler, with our options, keeps the roundings that the proofs rely on.
#include <gtest/gtest.h>

#include <cmath>

namespace firsthit {
namespace {

struct Pair {
    double x, y;
};

/// Two values at once, which GCC 12 vectorises; without our options it drops the rounding to float.
[[gnu::noinline]] Pair middles_as_floats(const float (&low)[2], const float (&high)[2])
{
    Pair middle;
    middle.x = float(0.5 * (double(low[0]) + double(high[0])));
    middle.y = float(0.5 * (double(low[1]) + double(high[1])));
    return middle;
}

TEST(Rounding, ToFloatIsKeptOnTheWayToDouble)
{
    const float low[2] = {1, -3},
                high[2] = {std::nextafter(1.0f, 2.0f), std::nextafter(-3.0f, 0.0f)};
    const Pair middle = middles_as_floats(low, high);
    EXPECT_EQ(middle.x, 1.0); // ties go to even
    EXPECT_EQ(middle.y, -3.0);
}

[[gnu::noinline]] double product_and_sum(double a, double b, double c)
{
    return a * b + c;
}

TEST(Rounding, OfAProductIsNotFusedAway)
{
    const double a = 1 + 0x1p-30;
    EXPECT_EQ(product_and_sum(a, a, -(1 + 0x1p-29)), 0.0);
}

} // namespace
} // namespace firsthit
