// instruction_sets.h - runs a check with each instruction set that kernels are compiled for.
#pragma once

#include "base/simd_targets.h"

#include <gtest/gtest.h>

namespace firsthit {

/// Calls check() as on a machine that has no better instruction set, for each that this one has.
template <class Check>
void for_instruction_sets(const Check& check)
{
    const auto choose = [](std::int64_t target) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    };
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        SCOPED_TRACE(hwy::TargetName(target));
        choose(target);
        check();
    }
    choose(0); // all of them again
}

} // namespace firsthit
