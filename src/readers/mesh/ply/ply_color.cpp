// ply_color.cpp - colours of a PLY file as linear light.
#include "readers/mesh/ply/ply_color.h"

#include "base/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace firsthit {
namespace {

double full_of(PlyType type)
{
    if (!is_whole(type)) return 1;
    return type == PlyType::uint16 ? 65535 : 255;
}

} // namespace

std::size_t make_linear(std::span<glm::vec4> colors, const PlyElement& element)
{
    const bool has_alpha = element.has(PlyRole::alpha);
    std::array<double, 4> full{};
    for (int k = 0; k < 4; ++k)
        if (k < 3 || has_alpha)
            full[std::size_t(k)] = full_of(element.type_of(PlyRole(int(PlyRole::red) + k)));
    std::size_t not_finite = 0;
    for (glm::vec4& color : colors) {
        if (!has_alpha) color.w = 1;
        bool finite = true;
        for (int k = 0; k < 4; ++k) {
            float& value = color[k];
            const bool known = std::isfinite(value);
            finite = finite && known;
            if (k == 3 && !has_alpha) continue;
            const double share = known ? double(value) / full[std::size_t(k)] : 1.0;
            if (k == 3)
                value = static_cast<float>(std::clamp(share, 0.0, 1.0));
            else
                value = linear_of_srgb(share);
        }
        not_finite += !finite;
    }
    return not_finite;
}

} // namespace firsthit
