// tasks.h - runs loops on a fixed number of threads (oneTBB).
#pragma once

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <optional>
#include <thread>

namespace firsthit {

/// A number of threads, handed to whoever loops. Results must not depend on it.
class Tasks {
  public:
    /// threads  0: one for each core
    explicit Tasks(int threads) : threads_(threads > 0 ? threads : cores()), arena_(threads_)
    {
        // TBB keeps to the number of cores unless told otherwise.
        if (threads_ > cores())
            more_.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(threads_));
    }

    int threads() const { return threads_; }

    /// Calls body(i, worker) for each i in [0, count), as workers become free. worker is below
    /// threads(), and no two calls with the same worker overlap.
    template <class Body>
    void for_each(std::size_t count, const Body& body)
    {
        if (threads_ == 1 || count <= 1) {
            for (std::size_t i = 0; i < count; ++i) body(i, std::size_t(0));
            return;
        }
        std::atomic<std::size_t> next{0};
        started_.fetch_add(1, std::memory_order_release);
        arena_.execute([&] {
            tbb::parallel_for(
                std::size_t(0), std::size_t(threads_),
                [&](std::size_t worker) {
                    (void)started_.load(std::memory_order_acquire);
                    for (std::size_t i = next++; i < count; i = next++) body(i, worker);
                    finished_.fetch_add(1, std::memory_order_release);
                },
                tbb::simple_partitioner());
        });
        (void)finished_.load(std::memory_order_acquire);
    }

    /// Calls body(first, last) for ranges of `grain` that cover [0, count).
    template <class Body>
    void for_ranges(std::size_t count, std::size_t grain, const Body& body)
    {
        for_each((count + grain - 1) / grain, [&](std::size_t range, std::size_t) {
            body(range * grain, std::min(count, (range + 1) * grain));
        });
    }

  private:
    static int cores() { return std::max(1, int(std::thread::hardware_concurrency())); }

    int threads_;
    // TBB orders the workers' memory by itself, but a thread sanitizer does not see into TBB: these
    // say the same in words that it knows.
    std::atomic<std::size_t> started_{0}, finished_{0};
    std::optional<tbb::global_control> more_;
    tbb::task_arena arena_;
};

} // namespace firsthit
