// tasks_test.cpp - loops on any number of threads.
#include "base/tasks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <thread>
#include <vector>

namespace firsthit {
namespace {

TEST(Tasks, CallEachIndexOnce)
{
    for (const int threads : {1, 2, 7})
        for (const std::size_t count : {0u, 1u, 2u, 1000u}) {
            std::vector<std::atomic<int>> calls(count);
            Tasks tasks(threads);
            tasks.for_each(count, [&](std::size_t i, std::size_t) { ++calls[i]; });
            for (const auto& number : calls) ASSERT_EQ(number, 1) << threads << " threads";
        }
}

TEST(Tasks, GiveNoWorkerTwoCallsAtOnce)
{
    for (const int threads : {1, 2, 7}) {
        Tasks tasks(threads);
        std::vector<std::atomic<bool>> busy(std::size_t(tasks.threads()));
        std::atomic<int> overlaps{0}, out_of_range{0};
        tasks.for_each(2000, [&](std::size_t, std::size_t worker) {
            if (worker >= busy.size()) {
                ++out_of_range;
                return;
            }
            if (busy[worker].exchange(true)) ++overlaps;
            std::this_thread::yield();
            busy[worker] = false;
        });
        EXPECT_EQ(out_of_range, 0);
        EXPECT_EQ(overlaps, 0);
    }
}

TEST(Tasks, CoverEachIndexOnceByRanges)
{
    for (const int threads : {1, 3})
        for (const std::size_t count : {0u, 1u, 6u, 7u, 8u, 1000u})
            for (const std::size_t grain : {1u, 7u, 4096u}) {
                std::vector<std::atomic<int>> calls(count);
                Tasks tasks(threads);
                tasks.for_ranges(count, grain, [&](std::size_t first, std::size_t last) {
                    EXPECT_LT(first, last);
                    EXPECT_LE(last - first, grain);
                    for (std::size_t i = first; i < last; ++i) ++calls[i];
                });
                for (const auto& number : calls) ASSERT_EQ(number, 1) << count << " by " << grain;
            }
}

TEST(Tasks, RunOnAllTheirThreadsAtOnceAlsoAboveTheCores)
{
    const int threads = int(std::thread::hardware_concurrency()) + 3;
    Tasks tasks(threads);
    ASSERT_EQ(tasks.threads(), threads);
    // Each worker waits in its first call for all others.
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    std::atomic<int> inside{0};
    tasks.for_each(std::size_t(threads), [&](std::size_t, std::size_t) {
        ++inside;
        while (inside < threads && std::chrono::steady_clock::now() < deadline)
            std::this_thread::yield();
    });
    EXPECT_LT(std::chrono::steady_clock::now(), deadline);
}

TEST(Tasks, AreOneForEachCoreWhereNoneAreAskedFor)
{
    EXPECT_GE(Tasks(0).threads(), 1);
    EXPECT_EQ(Tasks(0).threads(), std::max(1, int(std::thread::hardware_concurrency())));
}

TEST(Tasks, PassErrorsOn)
{
    for (const int threads : {1, 3}) {
        Tasks tasks(threads);
        EXPECT_THROW(tasks.for_each(100,
                         [](std::size_t i, std::size_t) {
                             if (i == 50) throw std::runtime_error("fifty");
                         }),
            std::runtime_error);
    }
}

TEST(Tasks, StopBeginningCallsAfterAnError)
{
    Tasks tasks(2);
    std::atomic<int> calls{0};
    EXPECT_THROW(tasks.for_each(1u << 30,
                     [&](std::size_t, std::size_t) {
                         if (++calls == 100) throw std::runtime_error("a hundred");
                     }),
        std::runtime_error);
    EXPECT_LT(calls, 1 << 30);
    calls = 0;
    tasks.for_each(1000, [&](std::size_t, std::size_t) { ++calls; });
    EXPECT_EQ(calls, 1000) << "the next loop";
}

TEST(Tasks, HelpAgainAfterTheyFellAsleep)
{
    Tasks tasks(2);
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    for (int round = 0; round < 3; ++round) {
        std::atomic<int> inside{0};
        tasks.for_each(2, [&](std::size_t, std::size_t) {
            ++inside;
            while (inside < 2 && std::chrono::steady_clock::now() < deadline)
                std::this_thread::yield();
        });
        ASSERT_EQ(inside, 2);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    EXPECT_LT(std::chrono::steady_clock::now(), deadline);
}

TEST(Tasks, KeepManyShortLoopsApart)
{
    Tasks tasks(3);
    std::uint64_t sum = 0;
    for (std::uint64_t loop = 0; loop < 20000; ++loop) {
        std::array<std::uint64_t, 3> of_worker{}; // gone when the next loop begins
        tasks.for_each(
            4, [&, loop](std::size_t i, std::size_t worker) { of_worker[worker] += loop * 4 + i; });
        sum += of_worker[0] + of_worker[1] + of_worker[2];
    }
    EXPECT_EQ(sum, std::uint64_t(80000) * 79999 / 2);
}

TEST(Tasks, LoopInsideOfALoopAndBesideIt)
{
    Tasks tasks(3);
    std::atomic<int> calls{0};
    const auto nested = [&] {
        tasks.for_each(50, [&](std::size_t, std::size_t) {
            tasks.for_each(20, [&](std::size_t, std::size_t) { ++calls; });
        });
    };
    std::thread other(nested);
    nested();
    other.join();
    EXPECT_EQ(calls, 2 * 50 * 20);
}

} // namespace
} // namespace firsthit
