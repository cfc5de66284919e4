// film.cpp - the names and shapes of a film's planes.
#include <firsthit/error.h>
#include <firsthit/film.h>

#include <fmt/format.h>

namespace firsthit {

namespace {

struct AovShape {
    std::string_view name;
    int channels;
};

// Indexed by Aov.
constexpr AovShape kShapes[kAovCount] = {
    {"item", 1},
    {"depth", 1},
    {"distance", 1},
    {"uv", 2},
    {"normal", 3},
    {"geometric_normal", 3},
    {"position", 3},
    {"albedo", 3},
    {"barycentric", 2},
    {"lit", 0}, // a channel a light
    {"instance", 1},
    {"material", 1},
    {"node", 1},
    {"tangent", 4},
    {"metallic_roughness", 2},
    {"emission", 3},
    {"motion", 2},
    {"motion_visible", 1},
    {"normal_camera", 3},
    {"position_camera", 3},
};

} // namespace

std::string_view aov_name(Aov aov)
{
    return kShapes[static_cast<std::size_t>(aov)].name;
}

int aov_channels(Aov aov)
{
    return kShapes[static_cast<std::size_t>(aov)].channels;
}

Aov aov_from_name(std::string_view name)
{
    std::string accepted;
    for (int a = 0; a < kAovCount; ++a) {
        if (kShapes[a].name == name) return static_cast<Aov>(a);
        accepted += accepted.empty() ? "" : ", ";
        accepted += kShapes[a].name;
    }
    throw ArgumentError(fmt::format("unknown plane '{}': accepted are {}", name, accepted));
}

} // namespace firsthit
