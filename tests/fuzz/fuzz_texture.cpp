// fuzz_texture.cpp - pictures of any bytes: they become textures, or are refused by a FileError.
#include "scene/image_file.h"

#include <firsthit/error.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    try {
        const firsthit::Texture texture =
            firsthit::decode_texture("picture", {reinterpret_cast<const char*>(data), size});
        for (const firsthit::Texture::Level& level : texture.levels)
            if (level.texel.size() != std::size_t(level.width) * std::size_t(level.height))
                std::abort();
    } catch (const firsthit::FileError&) {
    }
    return 0;
}
