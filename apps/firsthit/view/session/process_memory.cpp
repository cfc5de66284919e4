// process_memory.cpp - how much memory the program has.
#include "view/session/process_memory.h"

#include <unistd.h>

#include <fstream>

namespace firsthit::cli::view {

double memory_mb()
{
    std::ifstream file("/proc/self/statm");
    double pages = 0, resident = 0;
    file >> pages >> resident;
    return resident * double(sysconf(_SC_PAGESIZE)) / 1e6;
}

} // namespace firsthit::cli::view
