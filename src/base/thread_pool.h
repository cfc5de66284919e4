// thread_pool.h - threads that help with loops, and stay awake between them.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace firsthit {

/// Threads that take part in whatever the caller's thread runs. After each loop they stay awake for
/// a moment: a frame is a dozen loops, some of a tenth of a millisecond, and to wake a thread takes
/// a quarter of that. Then they sleep in the kernel until the next loop.
///
/// After fork() the child has no helpers: there run() works on the caller's thread alone, and the
/// destructor must not be called (see process_owned.h).
class ThreadPool {
  public:
    /// What everybody who takes part calls once, with its number.
    struct Work {
        void (*call)(void* context, std::size_t worker);
        void* context;
    };

    /// Starts that many threads, or fewer where the system has no more.
    explicit ThreadPool(int helpers);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    /// Calls work with 0 on the caller's thread, and with 1 to `helpers` on those that come before
    /// this is done; returns when all are. Inside of another run, or beside it, the caller works alone.
    /// throws  the first error that work threw
    void run(Work work);

  private:
    void help(std::size_t worker);
    std::uint32_t next_loop(std::uint32_t last) const;
    bool enter(std::uint32_t loop);
    void do_work(std::size_t worker);
    void rest() const;

    bool crowded_; // more threads than cores
    std::mutex error_mutex_;
    std::exception_ptr error_;
    std::atomic<bool> runs_{false};
    Work work_{};
    /// Whether the loop is open to helpers, how many came in, and its number; see thread_pool.cpp.
    std::atomic<std::uint32_t> state_{0};
    std::atomic<std::uint32_t> left_{0}; // of those who came in
    std::atomic<bool> ends_{false};
    std::vector<std::thread> helpers_; // last, so that they find all else made
};

} // namespace firsthit
