// check_settings.cpp - checks the settings and the view of a frame.
#include "render/check_settings.h"

#include "base/pixel_steps.h"
#include "exact/pencil.h"
#include "shadow/sky/sky_rays.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace firsthit {

namespace {

constexpr int kMaxSize = 65536;
constexpr std::int64_t kMaxPixels = std::int64_t(1) << 28;
constexpr int kMaxSamples = 16;
constexpr int kMinMap = 16, kMaxMap = 8192;
constexpr int kMaxFilter = 15;
constexpr int kMaxChunks = 64;

void check_shadows(const ShadowOptions& settings)
{
    const int size = settings.shadow_map_size;
    if (size != 0 && (size < kMinMap || size > kMaxMap))
        throw ArgumentError(
            fmt::format("shadow map size {} is out of range: {} to {}, or 0: by the picture", size,
                kMinMap, kMaxMap));
    if (!std::isfinite(settings.shadow_bias))
        throw ArgumentError(
            fmt::format("shadow bias {} is not finite: accepted are world units, or "
                        "any negative number: by the map's texels",
                settings.shadow_bias));
    if (settings.shadow_filter < 1 || settings.shadow_filter > kMaxFilter)
        throw ArgumentError(fmt::format(
            "shadow filter {} is out of range: 1 to {}", settings.shadow_filter, kMaxFilter));
}

void check_adaptive(const Settings& settings)
{
    const int n = settings.adaptive;
    if (n < 1 || n > kMaxSamples)
        throw ArgumentError(
            fmt::format("{} adaptive samples is out of range: 1 to {}", n, kMaxSamples));
    if (n > 1 && settings.samples > 1)
        throw ArgumentError(fmt::format(
            "{} adaptive samples need 1 sample everywhere else, not {}", n, settings.samples));
    if (n > 1 && settings.interleave > 1)
        throw ArgumentError(fmt::format("{} adaptive samples need a ray in each pixel, that is "
                                        "interleave 1, not {}",
            n, settings.interleave));
}

void check_opengl(const Settings& settings)
{
    if (settings.engine == Engine::gpu && settings.shadows == Shadows::exact)
        throw ArgumentError("the gpu engine has no exact shadows: accepted are maps or none, or "
                            "another engine");
    const int chunks = settings.opengl.readback_chunks;
    if (chunks < 1 || chunks > kMaxChunks)
        throw ArgumentError(
            fmt::format("{} readback chunks is out of range: 1 to {}", chunks, kMaxChunks));
}

} // namespace

void check_sky(const Sky& sky)
{
    check_sky_directions(sky.directions);
    if (sky.directions == 0) return;
    if (sky.up != glm::dvec3(0)) zenith_of(sky, sky.up);
    if (!(0 <= sky.bounce && sky.bounce <= 1))
        throw ArgumentError(fmt::format("the sky's bounce {} is out of range: 0 to 1", sky.bounce));
    for (const glm::vec3& color : {sky.color, sky.ground})
        for (int c = 0; c < 3; ++c)
            if (!(color[c] >= 0 && std::isfinite(color[c])))
                throw ArgumentError(fmt::format("the sky's light ({}, {}, {}) is out of range: "
                                                "accepted are finite numbers, 0 or more",
                    color.x, color.y, color.z));
}

View checked(const View& view)
{
    if (view.width < 1 || view.height < 1 || view.width > kMaxSize || view.height > kMaxSize)
        throw ArgumentError(fmt::format("picture size {}x{} is out of range: 1x1 to {}x{}",
            view.width, view.height, kMaxSize, kMaxSize));
    View filled = view;
    Region& region = filled.region;
    // If x or y is negative, the differences below could overflow.
    const bool starts_inside = region.x >= 0 && region.y >= 0;
    if (starts_inside && region.width == 0) region.width = view.width - region.x;
    if (starts_inside && region.height == 0) region.height = view.height - region.y;
    if (!starts_inside || region.width < 1 || region.height < 1 ||
        region.width > view.width - region.x || region.height > view.height - region.y)
        throw ArgumentError(fmt::format("region {}x{} at ({}, {}) does not lie in the picture, "
                                        "which is {}x{}",
            region.width, region.height, region.x, region.y, view.width, view.height));
    if (std::int64_t(region.width) * region.height > kMaxPixels)
        throw ArgumentError(fmt::format("{}x{} pixels are too many at once: at most {}",
            region.width, region.height, kMaxPixels));
    pencil_of(filled, region, 1); // checks the camera
    return filled;
}

void check(const Settings& settings, std::size_t lights)
{
    if (settings.samples < 1 || settings.samples > kMaxSamples)
        throw ArgumentError(
            fmt::format("{} samples is out of range: 1 to {}", settings.samples, kMaxSamples));
    if (settings.tile_size < 8 || settings.tile_size > 128 || settings.tile_size % 8 != 0)
        throw ArgumentError(fmt::format(
            "tile size {} is not accepted: a multiple of 8 from 8 to 128", settings.tile_size));
    if (!PixelSteps::is_known(settings.interleave))
        throw ArgumentError(
            fmt::format("interleave {} is not accepted: 1, 2, 4, 8 or 16", settings.interleave));
    if (settings.interleave > 1 && settings.samples > 1)
        throw ArgumentError(
            fmt::format("interleave {} needs 1 sample, not {}: it shoots less than a ray a pixel",
                settings.interleave, settings.samples));
    check_adaptive(settings);
    check_shadows(settings);
    check_sky(settings.sky);
    check_opengl(settings);
    if (std::find(settings.aovs.begin(), settings.aovs.end(), Aov::lit) == settings.aovs.end())
        return;
    if (lights == 0)
        throw ArgumentError("the plane 'lit' has a channel for each light, and there is no light");
    if (lights > kMaxLitLights)
        throw ArgumentError(fmt::format("the plane 'lit' has a channel for each light, and {} are "
                                        "too many: at most {}",
            lights, kMaxLitLights));
}

void check_background(const Scene& scene, const Settings& settings)
{
    if (settings.interleave > 1 && scene.environment.map && scene.environment.background)
        throw ArgumentError(fmt::format("interleave {} cannot show the environment as background: "
                                        "accepted are 1, or an environment without background",
            settings.interleave));
}

} // namespace firsthit
