// tasks_test.cpp - loops on any number of threads.
#include "base/tasks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
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

} // namespace
} // namespace firsthit
