// check_scene.cpp - does a scene keep its promises?
#include "scene/model/check_scene.h"

#include "scene/model/check_animation.h"
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
                    "xyzw"[at % kSize], flat[at]));
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
    const bool deforms = std::all_of(scene.instances.begin(), scene.instances.end(),
        [](const Instance& instance) { return static_cast<bool>(instance.deform); });
    const auto check = [&](std::size_t size, bool may_be_empty, const char* what) {
        if (size != scene.vertices && !(may_be_empty && size == 0))
            fail(scene, fmt::format("{} {} for {} vertices", size, what, scene.vertices));
    };
    check(scene.position.size(), deforms, "positions");
    check(scene.normal.size(), deforms, "normals");
    check(scene.uv.size(), true, "texture coordinates");
    check(scene.uv1.size(), true, "second texture coordinates");
    check(scene.color.size(), true, "vertex colours");
    check(scene.tangent.size(), true, "tangents");
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
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                if (!std::isfinite(node.local[column][row]))
                    fail(
                        scene, fmt::format("node {} '{}': its matrix is not finite", n, node.name));
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

bool all_finite(const MetallicRoughness& m)
{
    return all_finite(m.base_color) && all_finite(m.emission) && all_finite(m.f0) &&
           std::isfinite(m.metallic) && std::isfinite(m.roughness) && std::isfinite(m.specular) &&
           std::isfinite(m.normal_scale) && std::isfinite(m.occlusion_strength);
}

void check_map(const Scene& scene, const TextureRef& map, const std::string& what)
{
    check_number(scene, map.texture, scene.textures.size(), what + ": texture");
    if (map.uv_set != 0 && map.uv_set != 1)
        fail(scene,
            fmt::format("{}: there are no texture coordinates {}, but 0 and 1", what, map.uv_set));
    for (int column = 0; column < 3; ++column)
        if (!std::isfinite(map.transform[column].x) || !std::isfinite(map.transform[column].y))
            fail(scene, what + ": the transform of a texture is not finite");
}

void check_textures(const Scene& scene, const Phong& phong, const std::string& what)
{
    check_number(scene, phong.texture, scene.textures.size(), what + ": texture");
}

void check_textures(const Scene& scene, const Unlit& unlit, const std::string& what)
{
    check_map(scene, unlit.texture, what);
}

void check_textures(const Scene& scene, const MetallicRoughness& m, const std::string& what)
{
    for (const TextureRef* map : {&m.base_color_texture, &m.metallic_roughness_texture,
             &m.normal_texture, &m.occlusion_texture, &m.emission_texture, &m.specular_texture})
        check_map(scene, *map, what);
}

/// throws  SceneError: the value is not in 0 to 1
void check_share(const Scene& scene, float value, const std::string& what)
{
    if (!(0 <= value && value <= 1))
        fail(scene, fmt::format("{} is {}: accepted is 0 to 1", what, value));
}

void check_shares(const Scene& scene, const MetallicRoughness& m, const std::string& what)
{
    check_share(scene, m.metallic, what + ": metallic");
    check_share(scene, m.roughness, what + ": roughness");
}

/// Phong and Unlit have no shares.
template <class Model>
void check_shares(const Scene&, const Model&, const std::string&)
{
}

void check_materials(const Scene& scene)
{
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        const Material& material = scene.materials[m];
        const std::string what = fmt::format("material {} '{}'", m, material.name);
        std::visit(
            [&](const auto& model) {
                check_textures(scene, model, what);
                if (!all_finite(model)) fail(scene, what + " is not finite");
                check_shares(scene, model, what);
            },
            material.model);
        check_map(scene, material.opacity_texture, what + ": opacity");
        check_share(scene, material.opacity, what + ": opacity");
        if (!std::isfinite(material.alpha_cutoff))
            fail(scene, what + ": its alpha cutoff is not finite");
    }
}

void check_cameras(const Scene& scene)
{
    for (std::size_t c = 0; c < scene.cameras.size(); ++c)
        check_number(
            scene, scene.cameras[c].node, scene.nodes.size(), fmt::format("camera {}: node", c));
}

void check_lights(const Scene& scene)
{
    for (std::size_t l = 0; l < scene.lights.size(); ++l) {
        const Light& light = scene.lights[l];
        check_number(scene, light.node, scene.nodes.size(), fmt::format("light {}: node", l));
        const std::string fault = fault_of(light);
        if (!fault.empty()) fail(scene, fmt::format("light {}: {}", l, fault));
    }
}

void check_environment(const Scene& scene)
{
    const Environment& environment = scene.environment;
    if (!std::isfinite(environment.rotation_rad))
        fail(scene, "the rotation of the environment is not finite");
    if (!(environment.strength >= 0) || !std::isfinite(environment.strength))
        fail(scene,
            fmt::format("the environment's strength is {}: accepted are finite numbers from 0",
                environment.strength));
}

void check_morphs(const Scene& scene, const Instance& instance, const std::string& what)
{
    for (std::size_t k = 0; k < instance.morph.size(); ++k) {
        const MorphKey& key = instance.morph[k];
        if (key.position.size() != instance.vertex_count ||
            key.normal.size() != instance.vertex_count)
            fail(
                scene, fmt::format("{}: shape {} has {} positions and {} normals for {} vertices",
                           what, k, key.position.size(), key.normal.size(), instance.vertex_count));
        check_finite(scene, key.position, "shape position");
        check_finite(scene, key.normal, "shape normal");
        if (!std::isfinite(key.time_s)) fail(scene, fmt::format("{}: shape {}: time", what, k));
    }
}

/// The instance's triangles stay within its vertices and say that it owns them.
void check_triangles(const Scene& scene, std::uint32_t number, const std::string& what)
{
    const Instance& instance = scene.instances[number];
    const std::uint64_t first = instance.first_vertex;
    const std::uint64_t end = first + instance.vertex_count;
    for (std::size_t t = instance.first_triangle;
         t < std::size_t(instance.first_triangle) + instance.triangle_count; ++t) {
        const glm::uvec3& c = scene.index[t];
        if (std::min({c.x, c.y, c.z}) < first || std::max({c.x, c.y, c.z}) >= end)
            fail(scene, fmt::format("triangle {}: vertices {} {} {} are not all in {} to {} of {}",
                            t, c.x, c.y, c.z, first, end, what));
        if (scene.owner[t] != number)
            fail(scene, fmt::format("triangle {}: its owner is {}, but {} has it", t,
                            scene.owner[t], what));
    }
}

void check_instances(const Scene& scene)
{
    std::size_t next_triangle = 0;
    std::size_t next_vertex = 0;
    for (std::size_t p = 0; p < scene.instances.size(); ++p) {
        const Instance& instance = scene.instances[p];
        const std::string what = fmt::format("instance {} '{}'", p, instance.name);
        if (instance.node >= scene.nodes.size())
            fail(scene, fmt::format("{}: node {} is out of range ({})", what, instance.node,
                            scene.nodes.size()));
        if (instance.material >= scene.materials.size())
            fail(scene, fmt::format("{}: material {} is out of range ({})", what, instance.material,
                            scene.materials.size()));
        if (instance.first_triangle != next_triangle)
            fail(scene, fmt::format("{}: starts at triangle {}, {} is next", what,
                            instance.first_triangle, next_triangle));
        next_triangle += instance.triangle_count;
        if (next_triangle > scene.index.size())
            fail(scene, fmt::format("{}: ends at triangle {} of {}", what, next_triangle,
                            scene.index.size()));
        if (instance.first_vertex != next_vertex)
            fail(scene, fmt::format("{}: starts at vertex {}, {} is next", what,
                            instance.first_vertex, next_vertex));
        next_vertex += instance.vertex_count;
        if (next_vertex > scene.vertices)
            fail(scene,
                fmt::format("{}: ends at vertex {} of {}", what, next_vertex, scene.vertices));
        check_number(scene, instance.shape, scene.shapes.size(), what + ": shape");
        check_number(scene, instance.skin, scene.skins.size(), what + ": skin");
        if (instance.facet_normals &&
            instance.vertex_count != 3 * std::uint64_t(instance.triangle_count))
            fail(scene,
                what + ": its triangles share vertices, so facets have no normals of their own");
        check_morphs(scene, instance, what);
        check_deformation(scene, instance, what);
        check_triangles(scene, static_cast<std::uint32_t>(p), what);
    }
    if (next_triangle != scene.index.size())
        fail(scene, fmt::format("the instances have {} of {} triangles", next_triangle,
                        scene.index.size()));
}

} // namespace

void check_scene(const Scene& scene)
{
    check_sizes(scene);
    check_nodes(scene);
    check_animation(scene);
    check_materials(scene);
    check_lights(scene);
    check_environment(scene);
    check_cameras(scene);
    check_instances(scene);
    check_finite(scene, scene.position, "vertex");
    check_finite(scene, scene.normal, "normal");
    check_finite(scene, scene.uv, "texture coordinate");
    check_finite(scene, scene.uv1, "second texture coordinate");
    check_finite(scene, scene.color, "vertex colour");
    check_finite(scene, scene.tangent, "tangent");
}

} // namespace firsthit
