// instruction_set_test.cpp - FIRSTHIT_ISA lowers the instruction set.
#include "base/simd_targets.h"

#include "base/instruction_set.h"

#include <firsthit/error.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>

namespace firsthit {
namespace {

/// The choice is made once in a process, so each test makes it in a child process, which prints the
/// result to standard error and exits with 0, or with 1 after an error.
class InstructionSet : public testing::Test {
  protected:
    void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }

    [[noreturn]] static void choose(const char* wanted)
    {
        setenv("FIRSTHIT_ISA", wanted, 1);
        try {
            select_instruction_set();
        } catch (const ArgumentError& error) {
            std::fprintf(stderr, "%s\n", error.what());
            std::exit(1);
        }
        std::fprintf(stderr, "chosen: %s.\n", chosen_instruction_set().c_str());
        std::exit(0);
    }
};

TEST_F(InstructionSet, IsAnyThatIsNamedAndThatThisMachineHas)
{
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        const char* const name = hwy::TargetName(target);
        EXPECT_EXIT(
            choose(name), testing::ExitedWithCode(0), "chosen: " + std::string(name) + "\\.");
    }
}

TEST_F(InstructionSet, StaysAfterItWasAskedFor)
{
    const auto ask = [] {
        setenv("FIRSTHIT_ISA", "SCALAR", 1);
        select_instruction_set();
        const std::size_t chosen = hwy::GetChosenTarget().GetIndex();
        chosen_instruction_set();
        std::exit(hwy::GetChosenTarget().GetIndex() == chosen ? 0 : 1);
    };
    EXPECT_EXIT(ask(), testing::ExitedWithCode(0), "");
}

TEST_F(InstructionSet, ThatIsUnknownIsAnErrorThatListsTheOthers)
{
    const std::string best = chosen_instruction_set();
    EXPECT_EXIT(choose("AVX9"), testing::ExitedWithCode(1),
        "FIRSTHIT_ISA=AVX9 is not available here: accepted are " + best);
    EXPECT_EXIT(choose(""), testing::ExitedWithCode(1), "FIRSTHIT_ISA= is not available here");
}

} // namespace
} // namespace firsthit
