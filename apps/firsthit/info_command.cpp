// info_command.cpp - `firsthit info`: what is in a scene.
#include "info_command.h"

#include "common/output.h"
#include "common/usage.h"

#include <firsthit/scene.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace firsthit::cli {

namespace {

constexpr const char* kExamples = R"(Examples:
  firsthit info Robot.aff
  firsthit info bunny.stl --json

Memory is that of the scene and of one posed world, without the film. Bounds are at the begin of the
animation. Warnings go to stderr too. Exit codes: 0 done, 1 failed, 2 wrong usage.)";

template <class T>
std::uint64_t bytes(const std::vector<T>& values)
{
    return values.size() * sizeof(T);
}

std::uint64_t memory_of(const Scene& scene)
{
    std::uint64_t sum = bytes(scene.nodes) + bytes(scene.parts) + bytes(scene.materials) +
                        bytes(scene.lights) + bytes(scene.position) + bytes(scene.normal) +
                        bytes(scene.uv) + bytes(scene.index) + bytes(scene.owner);
    for (const Track& track : scene.tracks)
        sum += sizeof track + bytes(track.translation) + bytes(track.rotation) +
               bytes(track.scale) + bytes(track.visibility);
    for (const Part& part : scene.parts)
        for (const MorphKey& key : part.morph)
            sum += sizeof key + bytes(key.position) + bytes(key.normal);
    for (const Texture& texture : scene.textures)
        sum += sizeof texture + texture.texels().size_bytes();
    return sum;
}

std::uint64_t memory_of(const World& world)
{
    return bytes(world.position) + bytes(world.normal) + bytes(world.lights) +
           bytes(world.node_matrix) + bytes(world.node_visible);
}

/// How many lights of each kind there are.
Json light_kinds(const Scene& scene)
{
    const auto count = [&](Light::Kind kind) {
        return std::count_if(scene.lights.begin(), scene.lights.end(),
            [kind](const Light& light) { return light.kind == kind; });
    };
    return {{"point", count(Light::Kind::point)}, {"spot", count(Light::Kind::spot)},
        {"directional", count(Light::Kind::directional)}};
}

/// "2: 1 point, 1 spot"
std::string lights_text(const Json& info)
{
    std::string text = std::to_string(info["lights"].get<std::size_t>());
    const char* separator = ": ";
    for (const auto& [kind, count] : info["light_kinds"].items()) {
        if (count == 0) continue;
        text += fmt::format("{}{} {}", separator, count.get<std::size_t>(), kind);
        separator = ", ";
    }
    return text;
}

Json clips(const Scene& scene)
{
    Json list = Json::array();
    if (scene.end_s > scene.begin_s)
        list.push_back(
            {{"begin_s", scene.begin_s}, {"end_s", scene.end_s}, {"frames", scene.frames}});
    return list;
}

std::string camera_kind(const Scene& scene)
{
    if (scene.camera_track >= 0) return "animated";
    return scene.camera ? "still" : "none: frames the scene";
}

std::string vector_text(const Json& vector)
{
    return fmt::format("{:.6g} {:.6g} {:.6g}", vector[0].get<float>(), vector[1].get<float>(),
        vector[2].get<float>());
}

} // namespace

void add_info_options(CLI::App& app, InfoOptions& options)
{
    add_scene_options(app, options.scene);
    app.add_flag("--json", options.json, "Print one JSON object");
    app.footer(kExamples);
}

Json describe(const Scene& scene, const World& world, const std::string& name)
{
    const std::array<glm::vec3, 2> box = bounds(world);
    const auto vector = [](const glm::vec3& v) { return Json::array({v.x, v.y, v.z}); };
    return {
        {"scene", name},
        {"triangles", scene.triangle_count()},
        {"vertices", scene.vertex_count()},
        {"parts", scene.parts.size()},
        {"nodes", scene.nodes.size()},
        {"materials", scene.materials.size()},
        {"textures", scene.textures.size()},
        {"lights", scene.lights.size()},
        {"light_kinds", light_kinds(scene)},
        {"camera", camera_kind(scene)},
        {"clips", clips(scene)},
        {"bounds", {{"min", vector(box[0])}, {"max", vector(box[1])}}},
        {"memory_bytes", memory_of(scene) + memory_of(world)},
        {"warnings", scene.warnings},
    };
}

std::string info_text(const Json& info)
{
    std::string text;
    const auto line = [&](std::string_view name, const std::string& value) {
        fmt::format_to(std::back_inserter(text), "{:<10} {}\n", name, value);
    };
    line("scene", info["scene"].get<std::string>());
    for (const char* count : {"triangles", "vertices", "parts", "nodes", "materials", "textures"})
        line(count, std::to_string(info[count].get<std::size_t>()));
    line("lights", lights_text(info));
    line("camera", info["camera"].get<std::string>());
    line("clips", std::to_string(info["clips"].size()));
    for (const Json& clip : info["clips"])
        line("", fmt::format("{} s to {} s, {} frames", clip["begin_s"].get<double>(),
                     clip["end_s"].get<double>(), clip["frames"].get<int>()));
    line(
        "bounds", vector_text(info["bounds"]["min"]) + " to " + vector_text(info["bounds"]["max"]));
    line("memory", fmt::format("{:.1f} MB", info["memory_bytes"].get<double>() / 1e6));
    line("warnings", std::to_string(info["warnings"].size()));
    return text;
}

int run_info(const InfoOptions& options)
{
    const auto scene = std::make_shared<const Scene>(load(options.scene));
    World world;
    pose(scene, scene->begin_s, world);
    const Json info = describe(*scene, world, options.scene.name);
    print(options.json ? to_text(info) : info_text(info));
    return kExitDone;
}

} // namespace firsthit::cli
