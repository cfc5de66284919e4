// fuzz_environment.cpp - pictures of what is all around, of any bytes: they are read, or refused by a
// FileError.
#include "readers/image/environment_file.h"

#include <firsthit/error.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    try {
        const firsthit::RadiancePicture picture = bytes.starts_with("#?")
                                                      ? firsthit::decode_radiance("sky", bytes)
                                                      : firsthit::decode_exr("sky", bytes);
        const auto pixels = std::size_t(picture.width) * std::size_t(picture.height);
        if (picture.radiance.size() != pixels) std::abort();
    } catch (const firsthit::FileError&) {
    }
    return 0;
}
