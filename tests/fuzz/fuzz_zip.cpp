// fuzz_zip.cpp - the archive of a 3MF file, made of anything: its unit is a word of the file, or none.
#include "readers/assimp/unit_of_3mf.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    (void)firsthit::metres_of_3mf_unit(firsthit::unit_of_3mf(bytes));
    return 0;
}
