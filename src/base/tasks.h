// tasks.h - runs loops on a fixed number of threads (oneTBB).
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <thread>

namespace firsthit {

/// A number of threads, handed to whoever loops. Results must not depend on it.
class Tasks {
  public:
    /// threads  0: one for each core
    explicit Tasks(int threads)
        : threads_(threads > 0 ? threads : std::max(1, int(std::thread::hardware_concurrency()))),
          arena_(threads_)
    {
    }

    int threads() const { return threads_; }

    /// Calls body(first, last) for disjoint ranges that cover [0, count), about `grain` long each.
    /// On one thread it is one plain loop over the same ranges, in order.
    template <class Body> void for_ranges(std::size_t count, std::size_t grain, const Body& body)
    {
        if (threads_ == 1) {
            for (std::size_t first = 0; first < count; first += grain)
                body(first, std::min(count, first + grain));
            return;
        }
        const std::size_t ranges = (count + grain - 1) / grain;
        arena_.execute([&] {
            tbb::parallel_for(std::size_t(0), ranges, [&](std::size_t r) {
                body(r * grain, std::min(count, (r + 1) * grain));
            });
        });
    }

    /// The number of the thread that calls, below threads().
    static int thread_index() { return std::max(0, tbb::this_task_arena::current_thread_index()); }

  private:
    int threads_;
    tbb::task_arena arena_;
};

} // namespace firsthit
