// instruction_set.h - chooses the instruction set whose kernels run.
#pragma once

#include <string>

namespace firsthit {

/// Lowers the instruction set to the one that the environment variable FIRSTHIT_ISA names, if the
/// variable is set. Only the first call of a process has an effect; it must come before the first
/// kernel runs.
/// throws  ArgumentError: a name that this build does not have
void select_instruction_set();

/// "AVX3", "AVX2", "SSE4", "SCALAR", ...
std::string chosen_instruction_set();

} // namespace firsthit
