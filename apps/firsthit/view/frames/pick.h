// pick.h - what is under the pointer, and why it is dark.
#pragma once

#include <firsthit/render.h>
#include <firsthit/scene.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace firsthit::cli::view {

/// Whether one light reaches a point.
struct LightAtPoint {
    std::string name{};
    float share = 0; // 0 to 1
    std::string
        blocker{}; // where the share is 0: what stands in the way; or that the surface faces away
};

/// The surface that a pixel's ray meets.
struct Pick {
    int x = 0, y = 0; // pixel
    bool hit = false; // else there is only background
    std::uint32_t triangle = kNoItem;
    std::uint32_t instance = kNoItem;
    std::string instance_name{}, material_name{};
    float t = 0; // along the view axis
    glm::vec2 barycentric{0};
    glm::vec3 position{0};
    std::vector<LightAtPoint> lights{}; // empty where there are too many
};

/// Finds out what a pixel's ray meets, by rendering that pixel alone.
/// world  posed, with the lights where the view's camera has them
/// throws  as Renderer::render
Pick pick(Renderer& renderer, const World& world, const View& view, const Settings& settings, int x,
    int y);

/// How far along the view axis what a pixel sees is, in world units; 0: nothing.
/// throws  as Renderer::render
double seen_t(Renderer& renderer, const World& world, const View& view, int x, int y);

/// Lines to read.
std::vector<std::string> told(const Pick& pick);

} // namespace firsthit::cli::view
