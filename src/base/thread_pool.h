// thread_pool.h - helper threads for loops that spin for a moment before they sleep.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace firsthit {

/// Helper threads that run a loop together with the caller's thread. After a loop they spin for a
/// moment before they sleep in the kernel: a frame is a dozen loops, some of which take a tenth of
/// a millisecond, and waking a thread takes a quarter of that.
///
/// After fork() the child process has no helpers: run() works on the caller's thread alone, and the
/// destructor must not be called (see process_owned.h).
class ThreadPool {
  public:
    /// The function that every participating thread calls once, with its worker number.
    struct Work {
        void (*call)(void* context, std::size_t worker);
        void* context;
    };

    /// Starts that many threads, or fewer if the system cannot start more.
    explicit ThreadPool(int helpers);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    /// Calls work with worker 0 on the caller's thread, and with workers 1 to `helpers` on the
    /// helpers that arrive before that call has returned. Returns when all calls have returned.
    /// While another run is going on, in this or another thread, only the caller's thread takes
    /// part.
    /// throws  the first error that work threw
    void run(Work work);

  private:
    void help(std::size_t worker);
    std::uint32_t next_loop(std::uint32_t last) const;
    bool enter(std::uint32_t loop);
    void do_work(std::size_t worker);
    void pause() const;

    bool oversubscribed_; // more threads than cores
    std::mutex error_mutex_;
    std::exception_ptr error_;
    std::atomic<bool> running_{false};
    Work work_{};
    /// State of the current loop: number, helpers that entered, open or closed; see
    /// thread_pool.cpp.
    std::atomic<std::uint32_t> state_{0};
    std::atomic<std::uint32_t> finished_{0}; // helpers that entered the loop and have finished
    std::atomic<bool> stopping_{false};
    std::vector<std::thread> helpers_; // last: they use the members above
};

} // namespace firsthit
