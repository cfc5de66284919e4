// fuzz_texture.cpp - pictures of any bytes: they become textures, or are refused by a FileError.
#include "readers/image/image_file.h"

#include <firsthit/error.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    try {
        const firsthit::Texture texture =
            firsthit::decode_texture("picture", {reinterpret_cast<const char*>(data), size});
        const int last = texture.levels() - 1;
        if (texture.width(last) != 1 || texture.height(last) != 1) std::abort();
        texture.color(last, 0, 0);
    } catch (const firsthit::FileError&) {
    }
    return 0;
}
