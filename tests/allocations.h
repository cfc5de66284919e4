// allocations.h - counts what a test program allocates. Link allocations.cpp into that program
// only.
#pragma once

#include <cstddef>

namespace firsthit {

/// Calls of operator new so far, of any thread.
std::size_t allocations();

} // namespace firsthit
