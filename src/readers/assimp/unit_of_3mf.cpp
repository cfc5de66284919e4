// unit_of_3mf.cpp - the unit of lengths of a 3MF file, which Assimp does not tell.
//
// source  3MF Consortium, "3D Manufacturing Format, Core Specification" 1.3, 3.4: the element model;
//         PKWARE, ".ZIP File Format Specification" 6.3, 4.3: the parts of an archive
#include "readers/assimp/unit_of_3mf.h"

#include <stb/stb_image.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace firsthit {
namespace {

/// The element `model` is the first of a part; names of its extensions may stand before its unit.
constexpr std::size_t kFirstBytes = 1 << 14;

constexpr std::size_t kEnd = 22; // bytes of the end of the central directory, without a comment
constexpr std::size_t kComment = 0xFFFF; // the longest
constexpr std::size_t kEntry = 46;       // bytes of an entry of the directory, without its names
constexpr std::size_t kLocal = 30;       // bytes before a part, without its names

/// A whole number of `count` bytes, the lowest first; 0 beyond the end.
std::size_t number_at(std::string_view bytes, std::size_t at, std::size_t count)
{
    std::size_t number = 0;
    if (at > bytes.size() || bytes.size() - at < count) return 0;
    for (std::size_t k = count; k > 0; --k)
        number = number << 8 | static_cast<unsigned char>(bytes[at + k - 1]);
    return number;
}

/// A part of the archive.
struct Part {
    std::string_view packed;
    bool is_packed = false; // by "deflate"
};

/// The part that an entry of the directory names; empty where it is not in the archive.
Part part_of(std::string_view bytes, std::size_t entry)
{
    constexpr std::size_t kDeflate = 8;
    const std::size_t method = number_at(bytes, entry + 10, 2);
    const std::size_t size = number_at(bytes, entry + 20, 4);
    const std::size_t local = number_at(bytes, entry + 42, 4);
    if (local > bytes.size() || (method != 0 && method != kDeflate)) return {};
    const std::size_t begin =
        local + kLocal + number_at(bytes, local + 26, 2) + number_at(bytes, local + 28, 2);
    if (begin > bytes.size()) return {};
    return {bytes.substr(begin, size), method == kDeflate};
}

/// The part with the model: the one of the usual name, else the first that ends as models do.
Part find_model(std::string_view bytes)
{
    const std::size_t end = bytes.rfind("PK\5\6");
    if (end == bytes.npos || bytes.size() - end > kEnd + kComment) return {};
    std::size_t entry = number_at(bytes, end + 16, 4);
    Part found;
    for (std::size_t k = number_at(bytes, end + 10, 2); k > 0; --k) {
        if (entry > bytes.size() || !bytes.substr(entry).starts_with("PK\1\2")) break;
        const std::size_t length = number_at(bytes, entry + 28, 2);
        const std::string_view name = bytes.substr(std::min(entry + kEntry, bytes.size()), length);
        if (name == "3D/3dmodel.model") return part_of(bytes, entry);
        if (found.packed.empty() && name.ends_with(".model")) found = part_of(bytes, entry);
        entry +=
            kEntry + length + number_at(bytes, entry + 30, 2) + number_at(bytes, entry + 32, 2);
    }
    return found;
}

/// The first bytes of a part. What is damaged behind them does not matter.
std::string first_bytes(const Part& part)
{
    if (!part.is_packed) return std::string(part.packed.substr(0, kFirstBytes));
    std::string bytes(kFirstBytes, '\0');
    constexpr std::size_t kMostPacked = 2 * kFirstBytes; // what does not shrink is a little longer
    const int packed = static_cast<int>(std::min(part.packed.size(), kMostPacked));
    // It stops with an error where the buffer is full, which is what we want.
    stbi_zlib_decode_noheader_buffer(
        bytes.data(), static_cast<int>(bytes.size()), part.packed.data(), packed);
    return bytes;
}

} // namespace

std::string unit_of_3mf(std::string_view bytes)
{
    const std::string text = first_bytes(find_model(bytes));
    const std::size_t begin = text.find("<model");
    if (begin == text.npos) return {};
    std::string_view model = std::string_view(text).substr(begin);
    model = model.substr(0, model.find('>'));
    constexpr std::string_view kBlanks = " \t\r\n";
    for (std::size_t at = model.find("unit"); at != model.npos; at = model.find("unit", at + 1)) {
        if (kBlanks.find(model[at - 1]) == kBlanks.npos) continue;
        std::string_view rest = model.substr(at + 4);
        const auto skip = [&] {
            rest.remove_prefix(std::min(rest.find_first_not_of(kBlanks), rest.size()));
        };
        skip();
        if (!rest.starts_with('=')) continue;
        rest.remove_prefix(1);
        skip();
        if (rest.empty() || (rest[0] != '"' && rest[0] != '\'')) continue;
        const std::size_t close = rest.find(rest[0], 1);
        if (close != rest.npos) return std::string(rest.substr(1, close - 1));
    }
    return {};
}

std::optional<double> metres_of_3mf_unit(std::string_view unit)
{
    constexpr auto kUnits =
        std::to_array<std::pair<std::string_view, double>>({{"micron", 1e-6}, {"millimeter", 1e-3},
            {"centimeter", 1e-2}, {"inch", 0.0254}, {"foot", 0.3048}, {"meter", 1.0}});
    for (const auto& [name, metres] : kUnits)
        if (unit == name) return metres;
    return {};
}

} // namespace firsthit
