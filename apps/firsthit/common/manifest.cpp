// manifest.cpp - what the ids of a scene's planes stand for, with names.
#include "common/manifest.h"

#include <fmt/format.h>

#include <utility>
#include <variant>

namespace firsthit::cli {
namespace {

constexpr double kDegrees = 180 / 3.14159265358979323846;

/// A number, or null where it is -1.
Json number_or_null(std::int64_t number)
{
    return number < 0 ? Json() : Json(number);
}

struct ModelName {
    const char* operator()(const Phong&) const { return "phong"; }
    const char* operator()(const Unlit&) const { return "unlit"; }
    const char* operator()(const MetallicRoughness&) const { return "metallic-roughness"; }
};

const char* name_of(AlphaMode mode)
{
    return mode == AlphaMode::opaque ? "opaque" : mode == AlphaMode::mask ? "mask" : "blend";
}

const char* name_of(Light::Kind kind)
{
    return kind == Light::Kind::point  ? "point"
           : kind == Light::Kind::spot ? "spot"
                                       : "directional";
}

} // namespace

Json manifest_of_instances(const Scene& scene)
{
    Json list = Json::array();
    for (const Instance& instance : scene.instances) {
        const std::string mesh = instance.shape < 0
                                     ? instance.name
                                     : scene.shapes[static_cast<std::size_t>(instance.shape)].name;
        list.push_back({{"name", instance.name}, {"node", instance.node},
            {"material", instance.material}, {"mesh", mesh},
            {"skin", number_or_null(instance.skin)}, {"first_triangle", instance.first_triangle},
            {"triangles", instance.triangle_count}});
    }
    return list;
}

Json manifest_of_nodes(const Scene& scene)
{
    Json list = Json::array();
    for (const Node& node : scene.nodes)
        list.push_back({{"name", node.name}, {"parent", number_or_null(node.parent)}});
    return list;
}

Json manifest_of_materials(const Scene& scene)
{
    Json list = Json::array();
    for (const Material& material : scene.materials)
        list.push_back({{"name", material.name}, {"model", std::visit(ModelName(), material.model)},
            {"alpha", name_of(material.alpha)}});
    return list;
}

Json manifest_of_cameras(const Scene& scene)
{
    Json list = Json::array();
    for (const SceneCamera& camera : scene.cameras) {
        Json entry{{"name", camera.name}, {"node", number_or_null(camera.node)}};
        if (camera.camera.orthographic_height)
            entry["orthographic_height"] = *camera.camera.orthographic_height;
        else
            entry["fov_y_deg"] = camera.camera.fov_y_rad * kDegrees;
        list.push_back(std::move(entry));
    }
    return list;
}

Json manifest_of_lights(const Scene& scene)
{
    Json list = Json::array();
    for (const Light& light : scene.lights)
        list.push_back({{"name", light.name}, {"kind", name_of(light.kind)},
            {"node", number_or_null(light.node)}});
    return list;
}

Json manifest_of_clips(const Scene& scene)
{
    Json list = Json::array();
    for (const Clip& clip : scene.clips)
        list.push_back({{"name", clip.name}, {"begin_s", clip.begin_s}, {"end_s", clip.end_s},
            {"frames", clip.frames}, {"channels", clip.channels.size()}});
    return list;
}

std::uint32_t color_of_id(std::uint32_t id)
{
    // A permutation of the numbers below 2^21, seven bits of which are a part of the colour each.
    constexpr std::uint32_t kNumbers = 1u << 21, kOdd = 1297529u, kFirst = 778123u;
    const std::uint32_t mixed = (id * kOdd + kFirst) & (kNumbers - 1);
    const auto part = [&](int k) { return 96 + (mixed >> (14 - 7 * k) & 127) * 159 / 127; };
    return part(0) << 16 | part(1) << 8 | part(2);
}

Json manifest_of_ids(const Scene& scene)
{
    const auto numbered = [](const Json& list, bool colored) {
        Json result = Json::array();
        for (const Json& entry : list) {
            Json with = {{"id", result.size()}};
            if (colored)
                with["color"] = fmt::format("#{:06x}", color_of_id(std::uint32_t(result.size())));
            for (const auto& [key, value] : entry.items()) with[key] = value;
            result.push_back(std::move(with));
        }
        return result;
    };
    return {{"scene", scene.name}, {"none", kNoItem},
        {"instances", numbered(manifest_of_instances(scene), true)},
        {"nodes", numbered(manifest_of_nodes(scene), true)},
        {"materials", numbered(manifest_of_materials(scene), true)},
        {"lights", numbered(manifest_of_lights(scene), false)}};
}

} // namespace firsthit::cli
