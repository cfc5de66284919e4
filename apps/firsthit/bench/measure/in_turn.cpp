// in_turn.cpp - measures several ways to do the same thing, frame by frame in turn.
#include "bench/measure/in_turn.h"

#include <firsthit/error.h>

namespace firsthit::cli::bench {

std::vector<Times> measure_in_turn(const std::vector<Contender>& contenders, int rounds,
    int warm_up, const std::function<void()>& done)
{
    const std::size_t count = contenders.size();
    std::vector<Times> times(count);
    for (int round = -warm_up; round < rounds; ++round)
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t who = (k + std::size_t(round + warm_up)) % count;
            Times& mine = times[who];
            if (mine.failure.empty()) try {
                    const double ms = contenders[who].frame(round);
                    if (round >= 0) mine.ms.push_back(ms);
                } catch (const DeviceError& error) {
                    mine = {.ms = {}, .failure = error.what()};
                }
            if (done) done();
        }
    return times;
}

} // namespace firsthit::cli::bench
