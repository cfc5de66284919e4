// obj_colors.cpp - the colours of an OBJ file's vertices, which the format itself does not know.
#include "readers/mesh/obj/obj_colors.h"

#include "base/srgb.h"
#include "readers/mesh/obj/obj_lines.h"

#include <glm/vec4.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace firsthit {
namespace {

/// source  IEC 61966-2-1
float linear_value(float srgb)
{
    const double s = std::clamp(double(srgb), 0.0, 1.0);
    return static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
}

glm::vec4 linear_color(const glm::vec3& srgb)
{
    return {linear_value(srgb.r), linear_value(srgb.g), linear_value(srgb.b), 1};
}

/// Equal neighbours are common, and the power takes long.
std::vector<glm::vec4> linear_colors(const std::vector<glm::vec3>& srgb, float scale)
{
    std::vector<glm::vec4> linear;
    linear.reserve(srgb.size());
    for (std::size_t v = 0; v < srgb.size(); ++v)
        linear.push_back(
            v > 0 && srgb[v] == srgb[v - 1] ? linear.back() : linear_color(srgb[v] * scale));
    return linear;
}

} // namespace

void ObjColors::add(std::size_t vertex, const glm::vec3& srgb)
{
    srgb_.resize(vertex, glm::vec3(1));
    srgb_.push_back(srgb);
}

void ObjColors::add_codes(std::string_view text)
{
    constexpr std::size_t kDigits = 8;
    text = without_blanks(text);
    for (; text.size() >= kDigits; text.remove_prefix(kDigits)) {
        std::uint32_t code = 0;
        const auto [stop, error] = std::from_chars(text.data(), text.data() + kDigits, code, 16);
        if (error != std::errc() || stop != text.data() + kDigits) return;
        codes_.push_back(code & 0xFFFFFF);
    }
}

void ObjColors::finish(RawMesh& mesh) const
{
    if (!srgb_.empty()) {
        float most = 0;
        for (const glm::vec3& c : srgb_) most = std::max({most, c.r, c.g, c.b});
        // A little more than 1 is a rounding error.
        const bool bytes = most > 2;
        if (bytes) mesh.problems.add("vertex colours above 1 are taken to be out of 255");
        mesh.color = linear_colors(srgb_, bytes ? 1.0f / 255 : 1.0f);
    } else if (!codes_.empty()) {
        const std::array<float, 256>& linear = linear_from_srgb();
        for (const std::uint32_t c : codes_)
            mesh.color.emplace_back(linear[c >> 16], linear[c >> 8 & 255], linear[c & 255], 1);
        if (codes_.size() != mesh.position.size())
            mesh.problems.add("there are more or fewer #MRGB colours than vertices");
    }
    if (!mesh.color.empty()) mesh.color.resize(mesh.position.size(), glm::vec4(1));
}

} // namespace firsthit
