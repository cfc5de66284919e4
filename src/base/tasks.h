// tasks.h - runs loops on a fixed number of threads.
#pragma once

#include "base/process_owned.h"
#include "base/thread_pool.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>

namespace firsthit {

/// Runs loops on a number of threads. Results of a loop must not depend on that number.
class Tasks {
  public:
    /// threads  number of threads, including the caller's; 0: one for each core
    explicit Tasks(int threads) : threads_(threads > 0 ? threads : cores())
    {
        if (threads_ > 1) pool_ = make_process_owned<ThreadPool>(threads_ - 1);
    }

    int threads() const { return threads_; }

    /// Calls body(i, worker) for each i in [0, count), as workers become free. worker is less than
    /// threads(), and no two calls with the same worker overlap.
    /// throws  the first error that body threw; calls that had not begun by then are not made
    template <class Body>
    void for_each(std::size_t count, const Body& body)
    {
        if (threads_ == 1 || count <= 1) {
            for (std::size_t i = 0; i < count; ++i) body(i, std::size_t(0));
            return;
        }
        std::atomic<std::size_t> next{0};
        auto share = [&](std::size_t worker) {
            try {
                for (std::size_t i = next++; i < count; i = next++) body(i, worker);
            } catch (...) {
                next = count;
                throw;
            }
        };
        pool_->run(
            {[](void* s, std::size_t worker) { (*static_cast<decltype(share)*>(s))(worker); },
                &share});
    }

    /// Calls body(first, last) for ranges of `grain` elements that cover [0, count).
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
    ProcessOwned<ThreadPool> pool_; // null: everything runs on the caller's thread
};

} // namespace firsthit
