// random_numbers.h - numbers that tests draw.
#pragma once

#include <random>

namespace firsthit::test {

inline float uniform(std::mt19937& random, float low, float high)
{
    return std::uniform_real_distribution<float>(low, high)(random);
}

inline int whole(std::mt19937& random, int low, int high)
{
    return std::uniform_int_distribution<int>(low, high)(random);
}

} // namespace firsthit::test
