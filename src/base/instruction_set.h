// instruction_set.h - which of the compiled kernels run.
#pragma once

#include <string>

namespace firsthit {

/// Lowers the instruction set to the one that the environment variable FIRSTHIT_ISA names, if it is
/// set. Takes effect once a process, before the first kernel runs.
/// throws  ArgumentError: a name that this build does not have
void select_instruction_set();

/// "AVX3", "AVX2", "SSE4", "SCALAR", ...
std::string chosen_instruction_set();

} // namespace firsthit
