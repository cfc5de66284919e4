// glb.cpp - splits a GLB file into its chunks.
#include "readers/gltf/data/glb.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace firsthit::gltf {
namespace {

constexpr std::size_t kHeader = 12;     // magic, version, length
constexpr std::size_t kChunkHeader = 8; // length, type
constexpr std::uint32_t kJson = 0x4E4F534A;
constexpr std::uint32_t kBin = 0x004E4942;

std::uint32_t word(std::string_view bytes, std::size_t at)
{
    std::uint32_t value = 0;
    for (std::size_t k = 4; k-- > 0;)
        value = (value << 8) | static_cast<unsigned char>(bytes[at + k]);
    return value;
}

} // namespace

bool is_glb(std::string_view bytes)
{
    return bytes.starts_with("glTF");
}

Container split_glb(std::string_view bytes, const std::string& name)
{
    if (bytes.size() < kHeader)
        throw FileError(fmt::format("{}: the GLB file ends in its header", name));
    if (const std::uint32_t version = word(bytes, 4); version != 2)
        throw FileError(
            fmt::format("{}: a GLB file of version {}; accepted is 2 (glTF 2.0)", name, version));

    Container container;
    const std::size_t length = word(bytes, 8);
    if (length > bytes.size())
        container.warnings.push_back(
            fmt::format("its header promises {} bytes, it has {}", length, bytes.size()));
    std::size_t end = std::min(length, bytes.size());
    std::size_t at = kHeader;
    bool has_json = false;
    for (int chunk = 0; end - std::min(at, end) >= kChunkHeader; ++chunk) {
        const std::size_t size = word(bytes, at);
        const std::uint32_t type = word(bytes, at + 4);
        at += kChunkHeader;
        // A total length that is too small does not make a whole chunk unreadable.
        if (size > end - at && size <= bytes.size() - at) end = at + size;
        if (size > end - at)
            throw FileError(
                fmt::format("{}: the file is cut off: chunk {} at byte {} has {} bytes, "
                            "{} are left",
                    name, chunk, at - kChunkHeader, size, end - at));
        if (!has_json) {
            if (type != kJson)
                throw FileError(
                    fmt::format("{}: the first chunk of the GLB file is of type {:#010x}, not JSON",
                        name, type));
            container.json = bytes.substr(at, size);
            has_json = true;
        } else if (type == kBin && !container.has_binary) {
            if (chunk != 1) container.warnings.emplace_back("its BIN chunk is not the second one");
            container.binary = {bytes.data() + at, size};
            container.has_binary = true;
        } else if (type == kBin || type == kJson) {
            container.warnings.push_back(fmt::format(
                "there is a second {} chunk, which is not read", type == kBin ? "BIN" : "JSON"));
        } else {
            container.warnings.push_back(
                fmt::format("a chunk of unknown type {:#010x} is not read", type));
        }
        at += size;
        // Chunks start at multiples of four. Some writers leave the padding out of the length.
        if (at % 4 != 0) {
            container.warnings.emplace_back("the length of a chunk is no multiple of 4");
            const std::size_t padded = at + (4 - at % 4);
            const auto is_padding = [](char c) { return c == ' ' || c == '\0'; };
            if (padded <= end && std::all_of(bytes.begin() + std::ptrdiff_t(at),
                                     bytes.begin() + std::ptrdiff_t(padded), is_padding))
                at = padded;
        }
    }
    if (!has_json) throw FileError(fmt::format("{}: the GLB file has no JSON chunk", name));
    if (at < bytes.size())
        container.warnings.push_back(
            fmt::format("{} bytes after its last chunk are not read", bytes.size() - at));
    return container;
}

} // namespace firsthit::gltf
