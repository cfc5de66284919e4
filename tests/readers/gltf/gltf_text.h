// gltf_text.h - small glTF documents for tests.
#pragma once

#include "readers/gltf/document/document.h"
#include "message_of.h"

#include <firsthit/error.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace firsthit::gltf {

/// Reads a document of these members beside the asset, from memory and without a folder.
inline Document read_members(const std::string& members)
{
    const std::string asset = R"({"asset": {"version": "2.0"})";
    return read_document("t.gltf", asset + (members.empty() ? "" : ", ") + members + "}", {});
}

/// What the error says that such a document meets, or "no error".
inline std::string refusal(const std::string& members)
{
    return message_of<FileError>([&] { read_members(members); });
}

/// The warnings of such a document, each on a line.
inline std::string warnings_of(const Document& document)
{
    std::string lines;
    for (const std::string& warning : document.warnings) lines += warning + "\n";
    return lines;
}

template <class Number>
std::string bytes_of(const std::vector<Number>& numbers)
{
    return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

inline std::string base64(std::string_view bytes)
{
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = (group << 8) |
                    (at + k < bytes.size() ? static_cast<unsigned char>(bytes[at + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += at + k <= bytes.size() ? kDigits[(group >> (18 - 6 * k)) & 63] : '=';
    }
    return text;
}

/// "buffers" with these bytes, and "bufferViews" with a view of all of them.
/// more  members of the view, as R"("byteStride": 8)"
inline std::string one_buffer(const std::string& bytes, const std::string& more = "")
{
    const std::string length = std::to_string(bytes.size());
    return R"("buffers": [{"byteLength": )" + length +
           R"(, "uri": "data:application/octet-stream;base64,)" + base64(bytes) +
           R"("}], "bufferViews": [{"buffer": 0, "byteLength": )" + length +
           (more.empty() ? "" : ", ") + more + "}]";
}

inline std::string little_endian(std::uint32_t value)
{
    return {reinterpret_cast<const char*>(&value), sizeof(value)};
}

inline constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
inline constexpr std::uint32_t kBinChunk = 0x004E4942;

inline std::string chunk(std::uint32_t type, std::string bytes)
{
    while (bytes.size() % 4 != 0) bytes += type == kJsonChunk ? ' ' : '\0';
    return little_endian(static_cast<std::uint32_t>(bytes.size())) + little_endian(type) + bytes;
}

/// A GLB file of these chunks.
inline std::string glb(const std::string& chunks, std::uint32_t version = 2)
{
    return "glTF" + little_endian(version) +
           little_endian(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

} // namespace firsthit::gltf
