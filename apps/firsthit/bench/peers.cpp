// peers.cpp - `firsthit bench --peers`: the cpu engine's frames beside Embree's.
#include "bench/peers.h"

#include <firsthit/error.h>

namespace firsthit::cli::bench {

void add_peers(const BenchOptions&, Report&)
{
    throw DeviceError("--peers needs a build with Embree");
}

} // namespace firsthit::cli::bench
