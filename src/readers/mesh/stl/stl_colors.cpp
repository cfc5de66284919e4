// stl_colors.cpp - colours in the two spare bytes of binary STL facets.
#include "readers/mesh/stl/stl_colors.h"

#include "base/srgb.h"
#include "scene/model/default_material.h"

#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>
#include <variant>

namespace firsthit {
namespace {

constexpr std::size_t kStlHeader = 80;
constexpr std::size_t kStlFacet = 50;
constexpr std::uint16_t kBit15 = 0x8000;

std::uint16_t spare_bytes(const char* facets, std::size_t facet)
{
    std::uint16_t value = 0;
    std::memcpy(&value, facets + facet * kStlFacet + kStlFacet - 2, sizeof value);
    return value;
}

/// The colour of 5 bits each that begin at those bits.
glm::vec4 color_of(std::uint16_t bits, int red, int blue)
{
    const auto channel = [&](int first) { return linear_of_srgb((bits >> first & 31) / 31.0); };
    return {channel(red), channel(5), channel(blue), 1.0f};
}

/// The colour of all facets that Magics writes into the header.
std::optional<glm::vec4> header_color(std::string_view header)
{
    constexpr std::string_view kWord = "COLOR=";
    const std::size_t at = header.find(kWord);
    if (at == std::string_view::npos || at + kWord.size() + 4 > header.size()) return {};
    const auto byte = [&](std::size_t k) {
        return static_cast<std::uint8_t>(header[at + kWord.size() + k]);
    };
    const auto channel = [&](std::size_t k) { return linear_from_srgb()[byte(k)]; };
    return glm::vec4(channel(0), channel(1), channel(2), static_cast<float>(byte(3)) / 255);
}

} // namespace

std::vector<glm::vec4> stl_colors(const char* header, const char* facets, std::size_t count)
{
    bool any_bits = false, any_marked = false;
    for (std::size_t f = 0; f < count; ++f) {
        const std::uint16_t bits = spare_bytes(facets, f);
        any_bits = any_bits || bits != 0;
        any_marked = any_marked || (bits & kBit15) != 0;
    }
    const std::optional<glm::vec4> all = header_color(std::string_view(header, kStlHeader));
    if (!all && !any_marked) return {};

    const glm::vec4 grey(std::get<Phong>(default_material().model).diffuse, 1.0f);
    std::vector<glm::vec4> colors(count);
    for (std::size_t f = 0; f < count; ++f) {
        const std::uint16_t bits = spare_bytes(facets, f);
        const bool marked = (bits & kBit15) != 0;
        // Facets of nothing but zeros were not coloured: they would all be black.
        if (all)
            colors[f] = marked || !any_bits ? *all : color_of(bits, 0, 10);
        else
            colors[f] = marked ? color_of(bits, 10, 0) : grey;
    }
    return colors;
}

} // namespace firsthit
