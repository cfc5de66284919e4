// thread_pool.cpp - helper threads for loops that spin for a moment before they sleep.
#include "base/thread_pool.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

namespace firsthit {
namespace {

using Clock = std::chrono::steady_clock;

/// How long a waiting thread spins before it sleeps. Longer than the pauses between a frame's
/// loops.
constexpr auto kSpinTime = std::chrono::microseconds(150);

// The state of a loop is one word, so that no helper can enter a loop that was just closed:
//
//     bit 0        open: helpers may still enter
//     bits 1-11    how many helpers have entered
//     bits 12-31   the number of the loop
constexpr std::uint32_t kOpen = 1;
constexpr std::uint32_t kOneHelper = 2;
constexpr std::uint32_t kNextLoop = 1u << 12;
constexpr int kMostHelpers = int(kNextLoop / kOneHelper) - 1;

bool is_open(std::uint32_t state)
{
    return (state & kOpen) != 0;
}
std::uint32_t entered(std::uint32_t state)
{
    return state % kNextLoop / kOneHelper;
}
std::uint32_t number(std::uint32_t state)
{
    return state / kNextLoop;
}

/// Spins until the value differs from `old`, or for kSpinTime. Returns the value.
template <class Pause>
std::uint32_t spin_while(
    const std::atomic<std::uint32_t>& value, std::uint32_t old, const Pause& pause)
{
    const auto until = Clock::now() + kSpinTime;
    while (true) {
        for (int k = 0; k < 32; ++k) {
            const std::uint32_t now = value.load(std::memory_order_acquire);
            if (now != old) return now;
            pause();
        }
        if (Clock::now() > until) return old;
    }
}

} // namespace

ThreadPool::ThreadPool(int helpers)
    : oversubscribed_(helpers >= int(std::max(1u, std::thread::hardware_concurrency())))
{
    helpers = std::clamp(helpers, 0, kMostHelpers);
    helpers_.reserve(std::size_t(helpers));
    try {
        for (int k = 1; k <= helpers; ++k)
            helpers_.emplace_back([this, k] { help(std::size_t(k)); });
    } catch (const std::system_error&) {
        // The threads that could be started do the work.
    }
}

ThreadPool::~ThreadPool()
{
    stopping_.store(true, std::memory_order_relaxed);
    state_.fetch_add(kNextLoop);
    state_.notify_all();
    for (std::thread& helper : helpers_) helper.join();
}

void ThreadPool::run(Work work)
{
    if (running_.exchange(true, std::memory_order_acquire)) return work.call(work.context, 0);
    work_ = work;
    finished_.store(0, std::memory_order_relaxed);
    const std::uint32_t loop = (number(state_.load(std::memory_order_relaxed)) + 1) * kNextLoop;
    // Sequentially consistent, because notify_all reads a count of sleepers: otherwise a helper
    // that is about to sleep could be missed.
    state_.store(loop + kOpen);
    state_.notify_all();
    do_work(0);
    const std::uint32_t all = entered(state_.fetch_and(~kOpen, std::memory_order_acq_rel));
    for (std::uint32_t done = finished_.load(std::memory_order_acquire); done != all;) {
        const std::uint32_t now = spin_while(finished_, done, [&] { pause(); });
        if (now == done) finished_.wait(done, std::memory_order_acquire);
        done = finished_.load(std::memory_order_acquire);
    }
    const std::exception_ptr error = std::exchange(error_, nullptr);
    running_.store(false, std::memory_order_release);
    if (error) std::rethrow_exception(error);
}

void ThreadPool::help(std::size_t worker)
{
    std::uint32_t last = 0;
    while (true) {
        const std::uint32_t loop = next_loop(last);
        if (stopping_.load(std::memory_order_relaxed)) return;
        last = loop;
        if (!enter(loop)) continue;
        do_work(worker);
        finished_.fetch_add(1);
        finished_.notify_one();
    }
}

/// Waits for a loop other than `last`. Returns its number; it may be closed already.
std::uint32_t ThreadPool::next_loop(std::uint32_t last) const
{
    while (true) {
        const std::uint32_t state = state_.load(std::memory_order_acquire);
        if (number(state) != last) return number(state);
        if (spin_while(state_, state, [&] { pause(); }) == state)
            state_.wait(state, std::memory_order_acquire);
    }
}

/// Enters the loop of that number. False if it is closed.
bool ThreadPool::enter(std::uint32_t loop)
{
    std::uint32_t state = state_.load(std::memory_order_acquire);
    while (is_open(state) && number(state) == loop)
        if (state_.compare_exchange_weak(
                state, state + kOneHelper, std::memory_order_acq_rel, std::memory_order_acquire))
            return true;
    return false;
}

void ThreadPool::do_work(std::size_t worker)
{
    try {
        work_.call(work_.context, worker);
    } catch (...) {
        const std::lock_guard lock(error_mutex_);
        if (!error_) error_ = std::current_exception();
    }
}

/// One step of spinning. Yields the core to other threads if there are more threads than cores.
void ThreadPool::pause() const
{
#if defined(__x86_64__)
    if (!oversubscribed_) return __builtin_ia32_pause();
#endif
    std::this_thread::yield();
}

} // namespace firsthit
