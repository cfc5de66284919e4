// process_memory.h - how much memory the program has.
#pragma once

namespace firsthit::cli::view {

/// Resident memory, in units of 1e6 bytes.
double memory_mb();

} // namespace firsthit::cli::view
