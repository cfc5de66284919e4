// instruction_set.cpp - chooses the instruction set whose kernels run.
#include "base/simd_targets.h"

#include "base/instruction_set.h"

#include <firsthit/error.h>

#include <fmt/format.h>
#include <hwy/highway.h>

#include <bit>
#include <cstdlib>
#include <mutex>

namespace firsthit {
namespace {

/// Calls f(target) for each target that is compiled in and supported by this machine, best first.
template <class F>
void for_targets(const F& f)
{
    const std::int64_t supported = hwy::SupportedTargets();
    // SupportedTargets() has initialised the choice from all targets, including the disabled ones.
    hwy::GetChosenTarget().Update(supported);
    for (std::uint64_t rest = std::uint64_t(supported & HWY_TARGETS); rest; rest &= rest - 1)
        f(std::int64_t(1) << std::countr_zero(rest));
}

void lower_to(const std::string& wanted)
{
    std::int64_t better = 0;
    bool found = false;
    std::string names;
    for_targets([&](std::int64_t target) {
        const std::string name = hwy::TargetName(target);
        names += (names.empty() ? "" : ", ") + name;
        found |= name == wanted;
        if (!found) better |= target;
    });
    if (!found)
        throw ArgumentError(
            fmt::format("FIRSTHIT_ISA={} is not available here: accepted are {}", wanted, names));
    hwy::DisableTargets(better);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

} // namespace

void select_instruction_set()
{
    static std::once_flag once;
    std::call_once(once, [] {
        if (const char* wanted = std::getenv("FIRSTHIT_ISA")) lower_to(wanted);
    });
}

std::string chosen_instruction_set()
{
    std::string best;
    for_targets([&](std::int64_t target) {
        if (best.empty()) best = hwy::TargetName(target);
    });
    return best;
}

} // namespace firsthit
