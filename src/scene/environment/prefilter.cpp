// prefilter.cpp - diffuse terms and specular levels of an environment.
#include "scene/environment/prefilter.h"

#include <glm/gtc/constants.hpp>

#include <cstdint>
#include <numbers>

namespace firsthit {
namespace {

/// Integrals over one step of an angle, of 1, sin, cos, sin^2, sin cos, cos^2.
std::array<double, 6> step_integrals(double from, double to)
{
    const double width = to - from;
    const double sines = 0.25 * (std::sin(2 * to) - std::sin(2 * from));
    const double s0 = std::sin(from), s1 = std::sin(to);
    return {width, std::cos(from) - std::cos(to), s1 - s0, 0.5 * width - sines,
        0.5 * (s1 * s1 - s0 * s0), 0.5 * width + sines};
}

/// Integrals over one step of the angle from +y, times its sine, of 1, cos, sin, cos^2, sin cos, sin^2.
std::array<double, 6> row_integrals(double from, double to)
{
    const double c0 = std::cos(from), c1 = std::cos(to), s0 = std::sin(from), s1 = std::sin(to);
    const double cos2 = (c0 * c0 * c0 - c1 * c1 * c1) / 3;
    return {c0 - c1, 0.5 * (s1 * s1 - s0 * s0),
        0.5 * (to - from) - 0.25 * (std::sin(2 * to) - std::sin(2 * from)), cos2,
        (s1 * s1 * s1 - s0 * s0 * s0) / 3, c0 - c1 - cos2};
}

/// A picture of half the size; pixels at odd ends count with the last pair.
std::vector<glm::vec3> halved(Panorama& panorama)
{
    const Panorama& p = panorama;
    const int width = std::max(1, p.width / 2), height = std::max(1, p.height / 2);
    std::vector<glm::vec3> half;
    half.reserve(std::size_t(width) * std::size_t(height));
    const auto first = [](int k, int count, int whole) {
        return int(std::int64_t(k) * whole / count);
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            glm::dvec3 sum(0);
            int count = 0;
            for (int j = first(y, height, p.height); j < first(y + 1, height, p.height); ++j)
                for (int i = first(x, width, p.width); i < first(x + 1, width, p.width);
                     ++i, ++count)
                    sum += glm::dvec3(
                        p.radiance[std::size_t(j) * std::size_t(p.width) + std::size_t(i)]);
            half.emplace_back(sum / double(count));
        }
    panorama.width = width, panorama.height = height;
    return half;
}

/// The light from a direction, linear between the centres of pixels.
glm::dvec3 light_from(const Panorama& p, const glm::dvec3& d)
{
    const double around = std::atan2(d.x, -d.z) / (2 * std::numbers::pi) + 0.5;
    const double down = std::acos(std::clamp(d.y, -1.0, 1.0)) / std::numbers::pi;
    const double x = around * p.width - 0.5;
    const double y = std::clamp(down * p.height - 0.5, 0.0, double(p.height - 1));
    const int x0 = int(std::floor(x)), y0 = std::min(int(y), std::max(0, p.height - 2));
    const auto at = [&](int column, int row) {
        column = (column % p.width + p.width) % p.width;
        row = std::min(row, p.height - 1);
        return glm::dvec3(
            p.radiance[std::size_t(row) * std::size_t(p.width) + std::size_t(column)]);
    };
    const auto row_of = [&](int row) { return glm::mix(at(x0, row), at(x0 + 1, row), x - x0); };
    return glm::mix(row_of(y0), row_of(y0 + 1), y - y0);
}

/// One of the directions from which a level's texels gather light, about +z.
struct Gathered {
    glm::vec3 to_light;
    float weight;
    int level; // of the source
};

/// The i-th number of van der Corput's sequence in base 2.
double radical_inverse(std::uint32_t i)
{
    double sum = 0, digit = 0.5;
    for (; i > 0; i >>= 1, digit /= 2) sum += digit * (i & 1);
    return sum;
}

std::vector<Gathered> gathered(double roughness, int source_side, int last)
{
    // Measured on a lamp: within 0.06 of its light in the levels, of which half is their texels' size.
    const std::uint32_t count = roughness < 0.4 ? 64 : 128;
    const double alpha2 = std::pow(roughness, 4);
    std::vector<Gathered> all;
    double sum = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double u = (i + 0.5) / count, angle = 2 * std::numbers::pi * radical_inverse(i);
        const double cos2 = (1 - u) / (1 + (alpha2 - 1) * u), cosine = std::sqrt(cos2);
        const double n_l = 2 * cos2 - 1; // the eye is at n
        if (n_l <= 0) continue;
        const double sine = 2 * cosine * std::sqrt(1 - cos2);
        // The density of directions is D / 4, and a sample stands for its share of the sphere.
        const double d = alpha2 / (std::numbers::pi * std::pow(cos2 * (alpha2 - 1) + 1, 2));
        const double texels = 4 / (count * d) * source_side * source_side / (4 * std::numbers::pi);
        const int level = std::clamp(int(std::lround(0.5 * std::log2(texels) - 0.5)), 0, last);
        all.push_back(
            {glm::vec3(sine * std::cos(angle), sine * std::sin(angle), n_l), float(n_l), level});
        sum += n_l;
    }
    for (Gathered& sample : all) sample.weight = float(sample.weight / sum);
    return all;
}

} // namespace

std::array<glm::vec3, 9> diffuse_terms(const Panorama& p)
{
    // x = sin(down) sin(around), y = cos(down), z = -sin(down) cos(around), with `around` from -pi to pi.
    std::vector<std::array<double, 6>> columns;
    for (int x = 0; x < p.width; ++x)
        columns.push_back(step_integrals((double(x) / p.width * 2 - 1) * std::numbers::pi,
            (double(x + 1) / p.width * 2 - 1) * std::numbers::pi));
    glm::dvec3 l1(0), ly(0), lx(0), lz(0), lyy(0), lxy(0), lyz(0), lxx(0), lxz(0), lzz(0);
    for (int y = 0; y < p.height; ++y) {
        std::array<glm::dvec3, 6> around{};
        for (std::size_t x = 0; x < columns.size(); ++x) {
            const glm::dvec3 light(p.radiance[std::size_t(y) * columns.size() + x]);
            for (std::size_t k = 0; k < 6; ++k) around[k] += columns[x][k] * light;
        }
        const std::array<double, 6> down =
            row_integrals(std::numbers::pi * y / p.height, std::numbers::pi * (y + 1) / p.height);
        l1 += down[0] * around[0], ly += down[1] * around[0], lyy += down[3] * around[0];
        lx += down[2] * around[1], lz -= down[2] * around[2];
        lxy += down[4] * around[1], lyz -= down[4] * around[2];
        lxx += down[5] * around[3], lxz -= down[5] * around[4], lzz += down[5] * around[5];
    }
    // The squares of the harmonics' constants, times what a cosine lobe leaves of each band, over pi:
    // 1, 2/3, 1/4.
    const double band0 = 1 / (4 * std::numbers::pi), band1 = 2.0 / 3 * 3 / (4 * std::numbers::pi);
    const double band2 = 0.25 * 15 / (4 * std::numbers::pi), middle = band2 / 12;
    return {glm::vec3(band0 * l1), glm::vec3(band1 * ly), glm::vec3(band1 * lz),
        glm::vec3(band1 * lx), glm::vec3(band2 * lxy), glm::vec3(band2 * lyz),
        glm::vec3(middle * (3.0 * lzz - l1)), glm::vec3(band2 * lxz),
        glm::vec3(0.25 * band2 * (lxx - lyy))};
}

void unfold(const Panorama& panorama, const OctahedronTexels& level)
{
    Panorama source = panorama;
    std::vector<glm::vec3> memory;
    while (source.height > 2 * level.side) {
        std::vector<glm::vec3> half = halved(source);
        memory.swap(half);
        source.radiance = memory;
    }
    const int samples = source.height > level.side ? 2 : 1; // on a texel's side
    for (int row = 0; row < level.side; ++row)
        for (int column = 0; column < level.side; ++column) {
            glm::dvec3 sum(0);
            for (int k = 0; k < samples * samples; ++k) {
                const glm::dvec2 place((column + (k % samples + 0.5) / samples) / level.side,
                    (row + (k / samples + 0.5) / samples) / level.side);
                sum += light_from(source, octahedral_direction(place));
            }
            level.at(column, row) = glm::vec4(sum / double(samples * samples), 0);
        }
    level.fill_border();
}

OctahedronLevels::OctahedronLevels(const OctahedronTexels& finest) : level_{finest}
{
    while (level_.back().side > 1) {
        const OctahedronTexels finer = level_.back();
        const int side = finer.side / 2;
        memory_.emplace_back(std::size_t(side + 2) * std::size_t(side + 2));
        const OctahedronTexels coarser{memory_.back(), side};
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column)
                coarser.at(column, row) =
                    0.25f * ((finer.at(2 * column, 2 * row) + finer.at(2 * column + 1, 2 * row)) +
                                (finer.at(2 * column, 2 * row + 1) +
                                    finer.at(2 * column + 1, 2 * row + 1)));
        coarser.fill_border();
        level_.push_back(coarser);
    }
}

glm::vec4 OctahedronLevels::light(const glm::vec3& d, int level) const
{
    return level_[std::size_t(level)].bilinear(octahedral_place(d));
}

void prefilter(const OctahedronLevels& source, double roughness, const OctahedronTexels& level)
{
    const std::vector<Gathered> samples = gathered(roughness, source.side(), source.last());
    for (int row = 0; row < level.side; ++row)
        for (int column = 0; column < level.side; ++column) {
            const glm::dvec3 n =
                octahedral_direction({(column + 0.5) / level.side, (row + 0.5) / level.side});
            const glm::dvec3 other =
                std::abs(n.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
            const glm::vec3 x(glm::normalize(glm::cross(other, n)));
            const glm::vec3 z(n), y = glm::cross(z, x);
            glm::vec4 sum(0);
            for (const Gathered& s : samples)
                sum +=
                    s.weight *
                    source.light(s.to_light.x * x + s.to_light.y * y + s.to_light.z * z, s.level);
            level.at(column, row) = sum;
        }
    level.fill_border();
}

} // namespace firsthit
