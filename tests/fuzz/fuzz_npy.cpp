// fuzz_npy.cpp - NumPy arrays of any bytes: they become points, rays and ids, or are refused by a FileError.
#include <firsthit/error.h>
#include <firsthit/npy.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    try {
        if (firsthit::parse_npy_points(bytes, "fuzz").size() > size / 3) std::abort();
        if (firsthit::parse_npy_vectors(bytes, "fuzz").size() > size / 3) std::abort();
    } catch (const firsthit::FileError&) {
    }
    try {
        if (firsthit::parse_npy_rays(bytes, "fuzz").size() > size / 6) std::abort();
    } catch (const firsthit::FileError&) {
    }
    try {
        if (firsthit::parse_npy_ids(bytes, "fuzz").size() > size) std::abort();
    } catch (const firsthit::FileError&) {
    }
    return 0;
}
