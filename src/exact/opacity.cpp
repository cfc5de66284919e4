// opacity.cpp - how opaque a surface is at a point of a triangle.
#include "exact/opacity.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace firsthit {
namespace {

/// A triangle's vertices, and the weights of corners 1 and 2 at a point of it.
struct Place {
    const glm::uvec3& vertex;
    double u, v;

    /// The value at the point. It is exactly that of the corners where these have equal ones.
    double between(double a0, double a1, double a2) const
    {
        return (a0 + u * (a1 - a0)) + v * (a2 - a0);
    }
};

/// The texel that stands at a whole number k along an axis of n texels.
int wrapped(double k, int n, Wrap wrap)
{
    if (k >= 0 && k < n) return int(k);
    const double period = wrap == Wrap::mirror ? 2.0 * n : double(n);
    if (wrap == Wrap::clamp) return int(std::clamp(k, 0.0, double(n - 1)));
    double rest = std::fmod(k, period); // exact
    if (rest < 0) rest += period;
    return int(rest < n ? rest : period - 1 - rest);
}

/// The alpha of the texture's largest level at (x, y), where (0, 0) is the bottom left corner.
double alpha_at(const Texture& texture, double x, double y)
{
    const int width = texture.width(), height = texture.height();
    const Sampler& sampler = texture.sampler();
    // The largest level has a border of one texel. Texels are alpha times -32768.
    const Texel* const inner = texture.texels().data() + texture.first()[0] + (width + 2) + 1;
    const auto texel = [&](double column, double row) {
        const std::ptrdiff_t at = wrapped(row, height, sampler.wrap_v) * std::ptrdiff_t(width + 2) +
                                  wrapped(column, width, sampler.wrap_u);
        return double(inner[at][3]) / -32768.0;
    };
    const double column = x * width, row = (1 - y) * height;
    if (sampler.nearest) return texel(std::floor(column), std::floor(row));
    const double left = std::floor(column - 0.5), top = std::floor(row - 0.5);
    const double right_weight = (column - 0.5) - left, bottom_weight = (row - 0.5) - top;
    const auto between = [](double a, double b, double weight) { return a + weight * (b - a); };
    const double upper = between(texel(left, top), texel(left + 1, top), right_weight);
    const double lower = between(texel(left, top + 1), texel(left + 1, top + 1), right_weight);
    return between(upper, lower, bottom_weight);
}

/// The alpha of a texture as a material uses it.
double texture_alpha(const Scene& scene, const TextureRef& use, const Place& place)
{
    const Texture& texture = scene.textures[std::size_t(use.texture)];
    const std::vector<glm::vec2>& uv = use.uv_set == 1 ? scene.uv1 : scene.uv;
    if (texture.levels() == 0 || uv.empty()) return 1;
    const glm::vec2 &a = uv[place.vertex.x], &b = uv[place.vertex.y], &c = uv[place.vertex.z];
    const double s = place.between(a.x, b.x, c.x), t = place.between(a.y, b.y, c.y);
    const glm::mat3x2& m = use.transform;
    return alpha_at(texture, (double(m[0][0]) * s + double(m[1][0]) * t) + double(m[2][0]),
        (double(m[0][1]) * s + double(m[1][1]) * t) + double(m[2][1]));
}

} // namespace

float opacity(const Scene& scene, std::uint32_t triangle, float u, float v)
{
    const Material& material = scene.materials[scene.instances[scene.owner[triangle]].material];
    const Place place{scene.index[triangle], u, v};
    double alpha = 1;
    if (!scene.color.empty())
        alpha = place.between(scene.color[place.vertex.x].a, scene.color[place.vertex.y].a,
            scene.color[place.vertex.z].a);
    alpha *= double(material.opacity);
    if (material.opacity_texture.texture >= 0)
        alpha *= texture_alpha(scene, material.opacity_texture, place);
    return float(alpha);
}

} // namespace firsthit
