// fuzz_off.cpp - OFF files made of anything.
#include "fuzz_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    return firsthit::fuzz_mesh(data, size, ".off");
}
