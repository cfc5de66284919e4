// octahedron.h - directions on an unfolded octahedron, as src/glsl/environment.glsl looks them up.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace firsthit {

/// The unit direction at a place, 0 to 1 along both sides. Inverse of octahedral_place.
inline glm::dvec3 octahedral_direction(const glm::dvec2& place)
{
    double x = 2 * place.x - 1, z = 2 * place.y - 1;
    const double y = 1 - std::abs(x) - std::abs(z);
    if (y < 0) {
        const double folded_x = (1 - std::abs(z)) * (x < 0 ? -1 : 1);
        z = (1 - std::abs(x)) * (z < 0 ? -1 : 1);
        x = folded_x;
    }
    return glm::normalize(glm::dvec3(x, y, z));
}

/// octahedral_place of src/glsl/environment.glsl.
inline glm::vec2 octahedral_place(const glm::vec3& d)
{
    const float scale = 1 / (std::abs(d.x) + std::abs(d.y) + std::abs(d.z));
    float x = d.x * scale, z = d.z * scale;
    if (d.y < 0) {
        const float folded_x = (1 - std::abs(z)) * (x < 0 ? -1.0f : 1.0f);
        z = (1 - std::abs(x)) * (z < 0 ? -1.0f : 1.0f);
        x = folded_x;
    }
    return glm::clamp(0.5f * glm::vec2(x, z) + 0.5f, glm::vec2(0), glm::vec2(1));
}

/// Squares of (side + 2) x (side + 2) texels with a border that continues the octahedron's surface:
/// over an edge, it goes on mirrored at the edge's middle.
struct OctahedronTexels {
    std::span<glm::vec4> texel;
    int side = 0; // without the border

    /// Column and row are -1 to `side`.
    glm::vec4& at(int column, int row) const
    {
        return texel[std::size_t(row + 1) * std::size_t(side + 2) + std::size_t(column + 1)];
    }

    void fill_border() const
    {
        const int last = side - 1;
        for (int k = 0; k < side; ++k) {
            at(k, -1) = at(last - k, 0);
            at(k, side) = at(last - k, last);
            at(-1, k) = at(0, last - k);
            at(side, k) = at(last, last - k);
        }
        // A corner's four neighbours are the four corners of the square, all of them -y.
        at(-1, -1) = at(last, last), at(side, side) = at(0, 0);
        at(-1, side) = at(last, 0), at(side, -1) = at(0, last);
    }

    /// The four texels around a place, weighted.
    glm::vec4 bilinear(const glm::vec2& place) const
    {
        const float x = place.x * float(side) - 0.5f, y = place.y * float(side) - 0.5f;
        const float x0 = std::floor(x), y0 = std::floor(y);
        const glm::vec4* const top = &at(int(x0), int(y0));
        const glm::vec4* const bottom = top + side + 2;
        const glm::vec4 upper = top[0] + (top[1] - top[0]) * (x - x0);
        const glm::vec4 lower = bottom[0] + (bottom[1] - bottom[0]) * (x - x0);
        return upper + (lower - upper) * (y - y0);
    }
};

} // namespace firsthit
