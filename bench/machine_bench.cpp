// machine_bench.cpp - what one core of this machine can do at most: bandwidth of caches and memory,
// arithmetic for each instruction set, random access. The base of the rooflines in docs/performance_notes.md.
//
//     machine_bench [--rounds N]     N (15) times a few milliseconds each: best and median
//
// A core that others use too shows less; the best of many is nearest to the limit.
#include "machine_kernels.h"

#include "baselines.h"

#include "base/simd_targets.h"

#include <hwy/highway.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace firsthit {
namespace {

constexpr std::size_t kKilo = 1024, kMega = 1024 * kKilo;

/// A rate: how much in a nanosecond.
struct Rate {
    double best = 0;
    double median = 0;
};

/// f does some work and returns how much it was.
template <class F>
Rate measure(int rounds, const F& f)
{
    using Clock = std::chrono::steady_clock;
    std::vector<double> rates;
    f(); // pages, caches, clock
    for (int round = 0; round < rounds; ++round) {
        const auto start = Clock::now();
        const double amount = f();
        const std::chrono::duration<double, std::nano> spent = Clock::now() - start;
        rates.push_back(amount / spent.count());
    }
    return {*std::max_element(rates.begin(), rates.end()), median(rates)};
}

/// Memory of whole pages, small or huge.
class Pages {
  public:
    Pages(std::size_t bytes, bool huge) : bytes_(bytes)
    {
        // Aligned to huge pages, so that all of it can be in them.
        all_ = mmap(
            nullptr, bytes + 2 * kMega, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (all_ == MAP_FAILED) throw std::bad_alloc();
        const auto address = reinterpret_cast<std::uintptr_t>(all_);
        data_ =
            reinterpret_cast<std::uint8_t*>((address + 2 * kMega - 1) / (2 * kMega) * (2 * kMega));
        madvise(data_, bytes, huge ? MADV_HUGEPAGE : MADV_NOHUGEPAGE);
        std::memset(data_, 1, bytes);
    }
    ~Pages() { munmap(all_, bytes_ + 2 * kMega); }
    Pages(const Pages&) = delete;
    Pages& operator=(const Pages&) = delete;

    std::uint8_t* data() const { return data_; }

  private:
    std::size_t bytes_;
    void* all_ = nullptr;
    std::uint8_t* data_ = nullptr;
};

std::size_t cache_bytes(int name, std::size_t otherwise)
{
    const long bytes = sysconf(name);
    return bytes > 0 ? std::size_t(bytes) : otherwise;
}

struct Level {
    std::string name;
    std::size_t bytes; // of what is gone through
};

/// Half of a core's own caches; of the shared one 8 MiB, of which a virtual machine does not know how much
/// is its own; and more than any cache keeps from pass to pass.
std::vector<Level> levels()
{
    const auto half = [](std::size_t bytes) { return bytes / 2 / 4096 * 4096; };
    return {{"L1", half(cache_bytes(_SC_LEVEL1_DCACHE_SIZE, 32 * kKilo))},
        {"L2", half(cache_bytes(_SC_LEVEL2_CACHE_SIZE, 512 * kKilo))}, {"L3", 8 * kMega},
        {"memory", 1024 * kMega}};
}

void print(const char* name, const Rate& rate)
{
    std::printf("  %-40s %10.2f %10.2f\n", name, rate.best, rate.median);
}

/// Cycles of the core in a nanosecond: additions that wait for each other, one a cycle.
Rate clock_rate(int rounds)
{
    return measure(rounds, [] {
        constexpr int kCount = 2'000'000;
        std::uint64_t x = 1;
        for (int k = 0; k < kCount; ++k) {
            x += 3;
            asm volatile("" : "+r"(x));
            x += 5;
            asm volatile("" : "+r"(x));
        }
        return 2.0 * kCount;
    });
}

void measure_bandwidth(int rounds)
{
    const MachineKernels kernels = machine_kernels();
    for (const Level& level : levels()) {
        std::printf(
            "%s, %zu KiB one after the other, GB/s\n", level.name.c_str(), level.bytes / kKilo);
        const Pages pages(level.bytes, true);
        std::uint8_t* const data = pages.data();
        const std::size_t half = level.bytes / 2 / 4096 * 4096;
        // At least 16 MiB a round.
        const std::size_t repeats = std::max<std::size_t>(1, 16 * kMega / level.bytes);
        const auto row = [&](const char* what, double bytes, const auto& pass) {
            const Rate rate = measure(rounds, [&] {
                for (std::size_t k = 0; k < repeats; ++k) pass();
                return bytes * double(repeats);
            });
            print(what, rate);
        };
        const auto all = double(level.bytes);
        row("read", all, [&] {
            volatile std::uint32_t sink = kernels.read(data, level.bytes);
            (void)sink;
        });
        row("write", all, [&] { kernels.write(data, level.bytes); });
        row("copy, bytes read and written", double(2 * half),
            [&] { kernels.copy(data, data + half, half); });
        row("write past the caches", all, [&] { kernels.stream(data, level.bytes); });
    }
}

void measure_arithmetic(int rounds)
{
    constexpr double kCount = 4e7;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::GetChosenTarget().Update(target);
        const MachineKernels kernels = machine_kernels();
        std::printf(
            "arithmetic, %s, 10^9 operations a second, lane by lane\n", hwy::TargetName(target));
        print("float a * b + c, fused if it can be",
            measure(rounds, [&] { return kernels.fused_floats(kCount, 1.5f); }));
        print(
            "float a * b, then + c", measure(rounds, [&] { return kernels.floats(kCount, 1.5f); }));
        print("double a * b, then + c",
            measure(rounds, [&] { return kernels.doubles(kCount, 1.5); }));
        print("integer 32 x 32 bits to 64",
            measure(rounds, [&] { return kernels.products(kCount, 3); }));
    }
    hwy::GetChosenTarget().DeInit();
}

/// Nanoseconds instead of their inverse.
void print_ns(const char* name, const Rate& rate)
{
    print(name, {1 / rate.best, 1 / rate.median});
}

void measure_random(int rounds, bool huge)
{
    constexpr std::size_t kLine = 64, kBytes = 256 * kMega, kLines = kBytes / kLine;
    const Pages pages(kBytes, huge);
    std::uint8_t* const data = pages.data();
    // One cycle through all lines in random order (Sattolo 1986): each has the place of the next.
    std::vector<std::uint32_t> order(kLines);
    std::iota(order.begin(), order.end(), 0u);
    std::mt19937 random(1);
    for (std::size_t k = kLines - 1; k > 0; --k) std::swap(order[k], order[random() % k]);
    for (std::size_t k = 0; k < kLines; ++k)
        std::memcpy(data + std::size_t(order[k]) * kLine, &order[(k + 1) % kLines], 4);

    std::printf("random 16 bytes of 256 MiB, ns; %s\n",
        huge ? "huge pages, where the system gives them" : "pages of 4 KiB");
    std::uint32_t place = 0;
    print_ns("each waits for the one before", measure(rounds, [&] {
        constexpr int kCount = 50'000;
        for (int k = 0; k < kCount; ++k) std::memcpy(&place, data + std::size_t(place) * kLine, 4);
        asm volatile("" : "+r"(place));
        return double(kCount);
    }));
    std::size_t first = 0;
    const auto gather = [&](std::size_t ahead) {
        return measure(rounds, [&, ahead] {
            constexpr std::size_t kCount = 200'000;
            std::uint64_t sum = 0;
            first =
                (first + kCount) % (kLines - 2 * kCount); // other lines than those in the caches
            for (std::size_t k = first; k < first + kCount; ++k) {
                if (ahead) __builtin_prefetch(data + std::size_t(order[k + ahead]) * kLine);
                std::uint64_t pair[2];
                std::memcpy(pair, data + std::size_t(order[k]) * kLine, sizeof pair);
                sum += pair[0] ^ pair[1];
            }
            asm volatile("" : "+r"(sum));
            return double(kCount);
        });
    };
    print_ns("places known ahead", gather(0));
    print_ns("places known ahead, prefetched by 32", gather(32));
}

} // namespace
} // namespace firsthit

int main(int argc, char** argv)
{
    using namespace firsthit;
    int rounds = 15;
    if (argc == 3 && std::string(argv[1]) == "--rounds")
        rounds = std::clamp(std::atoi(argv[2]), 1, 1000);
    else if (argc != 1) {
        std::fprintf(stderr, "usage: machine_bench [--rounds N]\n");
        return 2;
    }
    std::printf("%-42s %10s %10s\n", "one core", "best", "median");
    print("clock, GHz", clock_rate(rounds));
    measure_bandwidth(rounds);
    measure_arithmetic(rounds);
    measure_random(rounds, false);
    measure_random(rounds, true);
    return 0;
}
