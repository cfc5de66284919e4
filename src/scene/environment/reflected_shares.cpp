// reflected_shares.cpp - the table of the split sum: which share of an even environment is reflected.
#include "scene/environment/prefilter.h"

#include <numbers>

namespace firsthit {
namespace {

/// Of the two numbers that choose a visible normal. Eight times as many change no value by 0.004.
constexpr int kSteps = 16, kTurns = 4; // half a turn: the other half is its mirror image

/// The points of a disc that choose visible normals.
struct Disc {
    double across[kSteps * kTurns], along[kSteps * kTurns], weight[kSteps * kTurns];

    Disc()
    {
        for (int k = 0; k < kSteps * kTurns; ++k) {
            // Denser at the disc's rim, where normals graze and what they reflect changes quickly.
            const double inward = 1 - (k / kTurns + 0.5) / kSteps;
            const double r = std::sqrt(1 - inward * inward);
            weight[k] = 2 * inward / (kSteps * kTurns);
            const double angle = std::numbers::pi * ((k % kTurns + 0.5) / kTurns - 0.5);
            across[k] = r * std::cos(angle), along[k] = r * std::sin(angle);
        }
    }
};

/// The share of f0 and of f90 that a surface reflects to an eye at cosine n_v.
///
/// With normals chosen as they are seen, what is left of a microfacet's share is Smith's shadowing of the
/// light alone, 1 / (1 + L(l)): src/material/metallic_roughness.glsl takes both shadowings apart, too.
glm::dvec2 share(double n_v, double alpha, const Disc& disc)
{
    const glm::dvec3 v(std::sqrt(1 - n_v * n_v), 0, n_v);
    const auto lambda = [&](double cosine) {
        const double tan2 = (1 - cosine * cosine) / (cosine * cosine);
        return 0.5 * (std::sqrt(1 + alpha * alpha * tan2) - 1);
    };
    const glm::dvec3 stretched = glm::normalize(glm::dvec3(alpha * v.x, 0, v.z));
    const glm::dvec3 across(0, 1, 0), along = glm::cross(stretched, across);
    const double s = 0.5 * (1 + stretched.z);
    glm::dvec2 sum(0);
    for (int k = 0; k < kSteps * kTurns; ++k) {
        const double t1 = disc.across[k];
        const double t2 = (1 - s) * std::sqrt(1 - t1 * t1) + s * disc.along[k];
        const glm::dvec3 h =
            t1 * across + t2 * along + std::sqrt(std::max(0.0, 1 - t1 * t1 - t2 * t2)) * stretched;
        const glm::dvec3 normal =
            glm::normalize(glm::dvec3(alpha * h.x, alpha * h.y, std::max(0.0, h.z)));
        const double v_h = glm::dot(v, normal);
        const double n_l = 2 * v_h * normal.z - v.z;
        if (n_l <= 0 || v_h <= 0) continue;
        const double seen = 1 / (1 + lambda(std::min(n_l, 1.0)));
        const double rest = 1 - std::min(v_h, 1.0), grazing = rest * rest * rest * rest * rest;
        sum += disc.weight[k] * seen * glm::dvec2(1 - grazing, grazing);
    }
    return sum;
}

} // namespace

std::vector<glm::vec4> reflected_shares(int side)
{
    const Disc disc;
    std::vector<glm::vec4> table;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const double roughness = std::max(0.045, double(row) / (side - 1));
            const double n_v = std::max(1e-3, double(column) / (side - 1));
            table.emplace_back(share(n_v, roughness * roughness, disc), 0, 0);
        }
    return table;
}

} // namespace firsthit
