// fuzz_obj.cpp - OBJ files and their material libraries, made of anything.
#include "fuzz_mesh.h"

#include "readers/mesh/mtl.h"

#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    try {
        firsthit::read_mtl(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz");
    } catch (const firsthit::Error&) {
        // As in fuzz_mesh.
    }
    return firsthit::fuzz_mesh(data, size, ".obj");
}
