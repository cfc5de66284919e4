// check_scene.cpp - does a scene keep its promises?
#include "scene/model/check_scene.h"

#include "scene/model/check_light.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <variant>

namespace firsthit {
namespace {

[[noreturn]] void fail(const Scene& scene, const std::string& what)
{
    throw SceneError(fmt::format("{}: {}", scene.name.empty() ? "scene" : scene.name, what));
}

/// The first value that is not finite, or -1. Sums x * 0, which is 0 for all finite x, so that the
/// good case runs without branches.
std::ptrdiff_t find_not_finite(std::span<const float> values)
{
    constexpr std::size_t kStride = 4096;
    for (std::size_t first = 0; first < values.size(); first += kStride) {
        const auto run = values.subspan(first, std::min(kStride, values.size() - first));
        float sums[8] = {};
        std::size_t i = 0;
        for (; i + 8 <= run.size(); i += 8)
            for (std::size_t k = 0; k < 8; ++k) sums[k] += run[i + k] * 0.0f;
        for (; i < run.size(); ++i) sums[0] += run[i] * 0.0f;
        if (std::all_of(std::begin(sums), std::end(sums), [](float s) { return s == 0.0f; }))
            continue;
        const auto bad =
            std::find_if_not(run.begin(), run.end(), [](float x) { return std::isfinite(x); });
        return static_cast<std::ptrdiff_t>(first) + (bad - run.begin());
    }
    return -1;
}

template <class Vector>
void check_finite(const Scene& scene, const std::vector<Vector>& values, const char* what)
{
    constexpr std::size_t kSize = static_cast<std::size_t>(Vector::length());
    if (values.empty()) return;
    const std::span<const float> flat(&values[0][0], values.size() * kSize);
    const std::ptrdiff_t bad = find_not_finite(flat);
    if (bad < 0) return;
    const auto at = static_cast<std::size_t>(bad);
    fail(scene, fmt::format("{} {}: {} is {}, not a finite number", what, at / kSize,
                    "xyz"[at % kSize], flat[at]));
}

void check_sizes(const Scene& scene)
{
    if (scene.index.size() >= kNoItem)
        fail(scene,
            fmt::format("{} triangles, at most {} are accepted", scene.index.size(), kNoItem - 1));
    if (scene.vertices > kNoItem)
        fail(scene, fmt::format("{} vertices, at most {} are accepted", scene.vertices, kNoItem));
    if (scene.owner.size() != scene.index.size())
        fail(scene,
            fmt::format("{} owners for {} triangles", scene.owner.size(), scene.index.size()));
    const bool deforms = std::all_of(scene.parts.begin(), scene.parts.end(),
        [](const Part& part) { return static_cast<bool>(part.deform); });
    const auto check = [&](std::size_t size, bool may_be_empty, const char* what) {
        if (size != scene.vertices && !(may_be_empty && size == 0))
            fail(scene, fmt::format("{} {} for {} vertices", size, what, scene.vertices));
    };
    check(scene.position.size(), deforms, "positions");
    check(scene.normal.size(), deforms, "normals");
    check(scene.uv.size(), true, "texture coordinates");
}

/// -1 means none.
void check_number(
    const Scene& scene, std::int64_t number, std::size_t count, const std::string& what)
{
    if (number < -1 || number >= static_cast<std::int64_t>(count))
        fail(scene, fmt::format("{} {} is out of range ({})", what, number, count));
}

void check_nodes(const Scene& scene)
{
    for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
        const Node& node = scene.nodes[n];
        if (node.parent < -1 || node.parent >= static_cast<std::int64_t>(n))
            fail(scene, fmt::format("node {} '{}': parent {} does not come before it", n, node.name,
                            node.parent));
        check_number(scene, node.track, scene.tracks.size(),
            fmt::format("node {} '{}': track", n, node.name));
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                if (!std::isfinite(node.local[column][row]))
                    fail(
                        scene, fmt::format("node {} '{}': its matrix is not finite", n, node.name));
    }
    check_number(scene, scene.camera_track, scene.tracks.size(), "the camera's track");
}

void check_keys(
    const Scene& scene, const Track& track, const std::vector<TrackKey>& keys, const char* what)
{
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const TrackKey& key = keys[k];
        // A sum that is finite has finite terms.
        const double sum = key.time_s * 0 + key.value.x * 0 + key.value.y * 0 + key.value.z * 0 +
                           key.value.w * 0 + key.tension * 0 + key.continuity * 0 + key.bias * 0;
        if (sum != 0 || std::isnan(sum))
            fail(scene, fmt::format("track '{}': {} key {} is not finite", track.name, what, k));
    }
}

void check_tracks(const Scene& scene)
{
    for (const Track& track : scene.tracks) {
        check_keys(scene, track, track.translation, "translation");
        check_keys(scene, track, track.rotation, "rotation");
        check_keys(scene, track, track.scale, "scale");
    }
}

bool all_finite(const glm::vec3& c)
{
    return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b);
}

bool all_finite(const Phong& phong)
{
    return all_finite(phong.ambient) && all_finite(phong.diffuse) && all_finite(phong.specular) &&
           std::isfinite(phong.shininess) && std::isfinite(phong.transmittance) &&
           std::isfinite(phong.ior);
}

bool all_finite(const Unlit& unlit)
{
    return all_finite(unlit.color);
}

void check_materials(const Scene& scene)
{
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        const Material& material = scene.materials[m];
        const std::string what = fmt::format("material {} '{}'", m, material.name);
        if (!material.double_sided) fail(scene, what + " has one side, which is not drawn yet");
        std::visit(
            [&](const auto& model) {
                check_number(scene, model.texture, scene.textures.size(), what + ": texture");
                if (!all_finite(model)) fail(scene, what + " is not finite");
            },
            material.model);
    }
}

void check_lights(const Scene& scene)
{
    for (std::size_t l = 0; l < scene.lights.size(); ++l) {
        const Light& light = scene.lights[l];
        check_number(scene, light.track, scene.tracks.size(), fmt::format("light {}: track", l));
        const std::string fault = fault_of(light);
        if (!fault.empty()) fail(scene, fmt::format("light {}: {}", l, fault));
    }
}

void check_morphs(const Scene& scene, const Part& part, const std::string& what)
{
    for (std::size_t k = 0; k < part.morph.size(); ++k) {
        const MorphKey& key = part.morph[k];
        if (key.position.size() != part.vertex_count || key.normal.size() != part.vertex_count)
            fail(scene, fmt::format("{}: shape {} has {} positions and {} normals for {} vertices",
                            what, k, key.position.size(), key.normal.size(), part.vertex_count));
        check_finite(scene, key.position, "shape position");
        check_finite(scene, key.normal, "shape normal");
        if (!std::isfinite(key.time_s)) fail(scene, fmt::format("{}: shape {}: time", what, k));
    }
}

/// The part's triangles stay within its vertices and say that it owns them.
void check_triangles(const Scene& scene, std::uint32_t number, const std::string& what)
{
    const Part& part = scene.parts[number];
    const std::uint64_t first = part.first_vertex;
    const std::uint64_t end = first + part.vertex_count;
    for (std::size_t t = part.first_triangle;
         t < std::size_t(part.first_triangle) + part.triangle_count; ++t) {
        const glm::uvec3& c = scene.index[t];
        if (std::min({c.x, c.y, c.z}) < first || std::max({c.x, c.y, c.z}) >= end)
            fail(scene, fmt::format("triangle {}: vertices {} {} {} are not all in {} to {} of {}",
                            t, c.x, c.y, c.z, first, end, what));
        if (scene.owner[t] != number)
            fail(scene, fmt::format("triangle {}: its owner is {}, but {} has it", t,
                            scene.owner[t], what));
    }
}

void check_parts(const Scene& scene)
{
    std::size_t next_triangle = 0;
    std::size_t next_vertex = 0;
    for (std::size_t p = 0; p < scene.parts.size(); ++p) {
        const Part& part = scene.parts[p];
        const std::string what = fmt::format("part {} '{}'", p, part.name);
        if (part.node >= scene.nodes.size())
            fail(scene, fmt::format("{}: node {} is out of range ({})", what, part.node,
                            scene.nodes.size()));
        if (part.material >= scene.materials.size())
            fail(scene, fmt::format("{}: material {} is out of range ({})", what, part.material,
                            scene.materials.size()));
        if (part.first_triangle != next_triangle)
            fail(scene, fmt::format("{}: starts at triangle {}, {} is next", what,
                            part.first_triangle, next_triangle));
        next_triangle += part.triangle_count;
        if (next_triangle > scene.index.size())
            fail(scene, fmt::format("{}: ends at triangle {} of {}", what, next_triangle,
                            scene.index.size()));
        if (part.first_vertex != next_vertex)
            fail(scene, fmt::format("{}: starts at vertex {}, {} is next", what, part.first_vertex,
                            next_vertex));
        next_vertex += part.vertex_count;
        if (next_vertex > scene.vertices)
            fail(scene,
                fmt::format("{}: ends at vertex {} of {}", what, next_vertex, scene.vertices));
        check_morphs(scene, part, what);
        check_triangles(scene, static_cast<std::uint32_t>(p), what);
    }
    if (next_triangle != scene.index.size())
        fail(scene,
            fmt::format("the parts have {} of {} triangles", next_triangle, scene.index.size()));
}

} // namespace

void check_scene(const Scene& scene)
{
    check_sizes(scene);
    check_nodes(scene);
    check_tracks(scene);
    check_materials(scene);
    check_lights(scene);
    check_parts(scene);
    check_finite(scene, scene.position, "vertex");
    check_finite(scene, scene.normal, "normal");
    check_finite(scene, scene.uv, "texture coordinate");
}

} // namespace firsthit
