// expansion_test.cpp - sums of doubles that lose nothing.
#include "exact/expansion.h"

#include <gtest/gtest.h>

#include <random>

namespace firsthit {
namespace {

__extension__ typedef __int128 Integer;

/// A double with `bits` significant bits at a random height, as an integer too.
double random_whole(std::mt19937_64& random, int bits, int shift, Integer& exact)
{
    const auto mantissa = std::int64_t(random() >> (64 - bits)) * (random() & 1 ? 1 : -1);
    exact = Integer(mantissa) << shift;
    return std::ldexp(double(mantissa), shift);
}

template <int N>
Integer value(const Expansion<N>& e)
{
    Integer sum = 0;
    for (int i = 0; i < e.size(); ++i) {
        int exponent = 0;
        const double mantissa = std::frexp(e[i], &exponent);
        const auto whole = std::int64_t(std::ldexp(mantissa, 53));
        exponent -= 53;
        sum += exponent >= 0 ? Integer(whole) << exponent : Integer(whole) >> -exponent;
    }
    return sum;
}

TEST(Expansion, AddsExactly)
{
    std::mt19937_64 random(1);
    for (int round = 0; round < 2000; ++round) {
        Expansion<12> sum;
        Integer exact = 0;
        for (int k = 0; k < 12; ++k) {
            Integer term;
            sum.add(random_whole(random, 40, int(random() % 70), term));
            exact += term;
        }
        EXPECT_TRUE(value(sum) == exact);
        EXPECT_EQ(sum.sign(), exact > 0 ? 1 : exact < 0 ? -1 : 0);
    }
}

TEST(Expansion, MultipliesExactly)
{
    std::mt19937_64 random(2);
    for (int round = 0; round < 2000; ++round) {
        Expansion<4> a, b;
        Integer exact_a = 0, exact_b = 0;
        for (int k = 0; k < 3; ++k) {
            Integer term;
            a.add(random_whole(random, 20, int(random() % 38), term));
            exact_a += term;
            b.add(random_whole(random, 20, int(random() % 38), term));
            exact_b += term;
        }
        Expansion<64> product;
        product.add_product(a, b, -1);
        EXPECT_TRUE(value(product) == -exact_a * exact_b);
    }
}

TEST(Expansion, KeepsItsValueWhenCompressed)
{
    std::mt19937_64 random(3);
    for (int round = 0; round < 2000; ++round) {
        Expansion<12> sum;
        for (int k = 0; k < 12; ++k) {
            Integer term;
            sum.add(random_whole(random, 30, int(random() % 80), term));
        }
        const Integer before = value(sum);
        const int size = sum.size();
        sum.compress();
        EXPECT_TRUE(value(sum) == before);
        EXPECT_LE(sum.size(), size);
    }
}

TEST(Expansion, CancelsToNothing)
{
    Expansion<8> sum;
    for (const double term : {1e30, 1.0, 1e-30, -1.0, -1e30, -1e-30}) sum.add(term);
    EXPECT_EQ(sum.sign(), 0);
    EXPECT_EQ(sum.size(), 0);
    EXPECT_EQ(sum.estimate(), 0);
}

} // namespace
} // namespace firsthit
