// thread_pool.cpp - threads that help with loops, and stay awake between them.
#include "base/thread_pool.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

namespace firsthit {
namespace {

using Clock = std::chrono::steady_clock;

/// How long a thread that waits stays awake. Between the loops of a frame are less.
constexpr auto kAwake = std::chrono::microseconds(150);

// The state of a loop: a bit, whether helpers may still come in; 11 bits, how many did; its number.
// One word, so that nobody comes in once it is closed.
constexpr std::uint32_t kOpen = 1;
constexpr std::uint32_t kOneMore = 2;
constexpr std::uint32_t kNextLoop = 1u << 12;
constexpr int kMostHelpers = int(kNextLoop / kOneMore) - 1;

bool is_open(std::uint32_t state)
{
    return (state & kOpen) != 0;
}
std::uint32_t came_in(std::uint32_t state)
{
    return state % kNextLoop / kOneMore;
}
std::uint32_t number(std::uint32_t state)
{
    return state / kNextLoop;
}

/// Returns when the value is no longer what it was, or after kAwake.
template <class Rest>
std::uint32_t watch(const std::atomic<std::uint32_t>& value, std::uint32_t was, const Rest& rest)
{
    const auto until = Clock::now() + kAwake;
    while (true) {
        for (int k = 0; k < 32; ++k) {
            const std::uint32_t now = value.load(std::memory_order_acquire);
            if (now != was) return now;
            rest();
        }
        if (Clock::now() > until) return was;
    }
}

} // namespace

ThreadPool::ThreadPool(int helpers)
    : crowded_(helpers >= int(std::max(1u, std::thread::hardware_concurrency())))
{
    helpers = std::clamp(helpers, 0, kMostHelpers);
    helpers_.reserve(std::size_t(helpers));
    try {
        for (int k = 1; k <= helpers; ++k)
            helpers_.emplace_back([this, k] { help(std::size_t(k)); });
    } catch (const std::system_error&) {
        // As many as there are do the work.
    }
}

ThreadPool::~ThreadPool()
{
    ends_.store(true, std::memory_order_relaxed);
    state_.fetch_add(kNextLoop);
    state_.notify_all();
    for (std::thread& helper : helpers_) helper.join();
}

void ThreadPool::run(Work work)
{
    if (runs_.exchange(true, std::memory_order_acquire)) return work.call(work.context, 0);
    work_ = work;
    left_.store(0, std::memory_order_relaxed);
    const std::uint32_t loop = (number(state_.load(std::memory_order_relaxed)) + 1) * kNextLoop;
    state_.store(loop + kOpen); // in one order with the count of sleepers that notify_all reads
    state_.notify_all();
    do_work(0);
    const std::uint32_t all = came_in(state_.fetch_and(~kOpen, std::memory_order_acq_rel));
    for (std::uint32_t left = left_.load(std::memory_order_acquire); left != all;) {
        const std::uint32_t now = watch(left_, left, [&] { rest(); });
        if (now == left) left_.wait(left, std::memory_order_acquire);
        left = left_.load(std::memory_order_acquire);
    }
    const std::exception_ptr error = std::exchange(error_, nullptr);
    runs_.store(false, std::memory_order_release);
    if (error) std::rethrow_exception(error);
}

void ThreadPool::help(std::size_t worker)
{
    std::uint32_t last = 0;
    while (true) {
        const std::uint32_t loop = next_loop(last);
        if (ends_.load(std::memory_order_relaxed)) return;
        last = loop;
        if (!enter(loop)) continue;
        do_work(worker);
        left_.fetch_add(1);
        left_.notify_one();
    }
}

/// The number of a loop that is not the last; it need not be open any more.
std::uint32_t ThreadPool::next_loop(std::uint32_t last) const
{
    while (true) {
        const std::uint32_t state = state_.load(std::memory_order_acquire);
        if (number(state) != last) return number(state);
        if (watch(state_, state, [&] { rest(); }) == state)
            state_.wait(state, std::memory_order_acquire);
    }
}

/// Whether the helper takes part in the loop of that number.
bool ThreadPool::enter(std::uint32_t loop)
{
    std::uint32_t state = state_.load(std::memory_order_acquire);
    while (is_open(state) && number(state) == loop)
        if (state_.compare_exchange_weak(
                state, state + kOneMore, std::memory_order_acq_rel, std::memory_order_acquire))
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

/// A moment of waiting. Where threads share cores, others may go on.
void ThreadPool::rest() const
{
#if defined(__x86_64__)
    if (!crowded_) return __builtin_ia32_pause();
#endif
    std::this_thread::yield();
}

} // namespace firsthit
