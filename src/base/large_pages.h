// large_pages.h - asks the system to back large memory by large pages.
#pragma once

#include <cstddef>

namespace firsthit {

/// Memory that has not been written yet. Scattered reads of some megabytes otherwise spend much of
/// their time in finding out where a page is. What cannot be had is done without.
void ask_for_large_pages(void* memory, std::size_t bytes);

} // namespace firsthit
