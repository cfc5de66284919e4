// info_command.cpp - `firsthit info`: what is in a scene.
#include "info_command.h"

#include "common/manifest.h"
#include "common/output.h"
#include "inputs/scene_source.h"
#include "common/usage.h"

#include <firsthit/scene.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace firsthit::cli {

namespace {

constexpr const char* kInfoExamples = R"(Examples:
  firsthit info Robot.aff
  firsthit info bunny.stl --json
  firsthit info frames/%04d.obj --fps 30

Memory is that of the scene and of one posed world, without the film. Bounds are at the begin of the
animation. Of numbered files all are read: "sequence" counts them, the rest is of the first. Warnings go to stderr too. Exit codes: 0 done, 1 failed, 2 wrong usage.)";

constexpr std::size_t kMostListed = 16; // lines for people

template <class T>
std::uint64_t bytes(const std::vector<T>& values)
{
    return values.size() * sizeof(T);
}

std::uint64_t memory_of(const Scene& scene)
{
    std::uint64_t sum = bytes(scene.nodes) + bytes(scene.instances) + bytes(scene.materials) +
                        bytes(scene.lights) + bytes(scene.position) + bytes(scene.normal) +
                        bytes(scene.uv) + bytes(scene.uv1) + bytes(scene.color) +
                        bytes(scene.tangent) + bytes(scene.index) + bytes(scene.owner);
    for (const Clip& clip : scene.clips)
        for (const Channel& channel : clip.channels)
            sum +=
                sizeof channel + bytes(channel.time_s) + bytes(channel.value) + bytes(channel.tcb);
    for (const MeshShape& shape : scene.shapes) {
        sum += bytes(shape.skin.joint) + bytes(shape.skin.weight);
        for (const MorphTarget& target : shape.targets)
            sum += bytes(target.position) + bytes(target.normal) + bytes(target.tangent);
    }
    for (const Instance& instance : scene.instances)
        for (const MorphKey& key : instance.morph)
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
    std::string text = std::to_string(info["lights"].size());
    const char* separator = ": ";
    for (const auto& [kind, count] : info["light_kinds"].items()) {
        if (count == 0) continue;
        text += fmt::format("{}{} {}", separator, count.get<std::size_t>(), kind);
        separator = ", ";
    }
    return text;
}

/// "clip 2 'walk'", or without a name.
std::string named(std::size_t number, const std::string& name)
{
    return name.empty() ? std::to_string(number) : fmt::format("{} '{}'", number, name);
}

std::string vector_text(const Json& vector);

/// "least to most", or one number where they are the same.
std::string range_text(const Json& range)
{
    const auto least = range["min"].get<std::size_t>(), most = range["max"].get<std::size_t>();
    return least == most ? std::to_string(least) : fmt::format("{} to {}", least, most);
}

/// The lines of a sequence.
template <class Line>
void add_sequence_text(const Json& sequence, const Line& line)
{
    line("sequence", fmt::format("{} frames, {:.6g} a second, {:.6g} s to {:.6g} s",
                         sequence["frames"].get<std::size_t>(), sequence["fps"].get<double>(),
                         sequence["begin_s"].get<double>(), sequence["end_s"].get<double>()));
    line("", fmt::format("{} to {}", sequence["first"].get<std::string>(),
                 sequence["last"].get<std::string>()));
    line("", range_text(sequence["triangles"]) + " triangles");
    line("", range_text(sequence["vertices"]) + " vertices");
    line("",
        vector_text(sequence["bounds"]["min"]) + " to " + vector_text(sequence["bounds"]["max"]));
    const Json& changes = sequence["new_topology"];
    line("", changes.empty()
                 ? "one topology: frames are interpolated"
                 : fmt::format("the topology changes {} times (first at frame {}): stepped there",
                       changes.size(), changes[0].get<std::size_t>()));
    line("first frame", "");
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
    app.footer(kInfoExamples);
}

Json describe(const Scene& scene, const World& world, const std::string& name)
{
    const std::array<glm::vec3, 2> box = bounds(world);
    const auto vector = [](const glm::vec3& v) { return Json::array({v.x, v.y, v.z}); };
    return {
        {"scene", name},
        {"triangles", scene.triangle_count()},
        {"vertices", scene.vertex_count()},
        {"instances", manifest_of_instances(scene)},
        {"nodes", manifest_of_nodes(scene)},
        {"materials", manifest_of_materials(scene)},
        {"textures", scene.textures.size()},
        {"skins", scene.skins.size()},
        {"lights", manifest_of_lights(scene)},
        {"light_kinds", light_kinds(scene)},
        {"cameras", manifest_of_cameras(scene)},
        {"clips", manifest_of_clips(scene)},
        {"bounds", {{"min", vector(box[0])}, {"max", vector(box[1])}}},
        {"memory_bytes", memory_of(scene) + memory_of(world)},
        {"extensions", scene.extensions},
        {"warnings", scene.warnings},
    };
}

Json describe(SceneSequence& sequence)
{
    const SequenceSummary all = sequence.summary();
    const auto range = [](const auto& low, const auto& high) {
        return Json{{"min", low}, {"max", high}};
    };
    const auto vector = [](const glm::vec3& v) { return Json::array({v.x, v.y, v.z}); };
    return {
        {"frames", sequence.frames()},
        {"fps", sequence.fps()},
        {"begin_s", 0.0},
        {"end_s", sequence.end_s()},
        {"first", sequence.file(0)},
        {"last", sequence.file(sequence.frames() - 1)},
        {"triangles", range(all.triangles[0], all.triangles[1])},
        {"vertices", range(all.vertices[0], all.vertices[1])},
        {"bounds", range(vector(all.bounds[0]), vector(all.bounds[1]))},
        {"new_topology", all.new_topology},
        {"warnings", sequence.warnings()},
    };
}

std::string info_text(const Json& info)
{
    std::string text;
    const auto line = [&](std::string_view name, const std::string& value) {
        fmt::format_to(std::back_inserter(text), "{:<11}{}\n", name, value);
    };
    line("scene", info["scene"].get<std::string>());
    if (info.contains("sequence")) add_sequence_text(info["sequence"], line);
    for (const char* count : {"triangles", "vertices"})
        line(count, std::to_string(info[count].get<std::size_t>()));
    for (const char* list : {"instances", "nodes"}) line(list, std::to_string(info[list].size()));
    const auto list = [&](const char* name, const auto& text_of) {
        line(name, std::to_string(info[name].size()));
        std::size_t number = 0;
        for (const Json& entry : info[name]) {
            if (number == kMostListed) {
                line("", fmt::format("and {} more (--json has all)", info[name].size() - number));
                break;
            }
            line("", named(number++, entry["name"].template get<std::string>()) + text_of(entry));
        }
    };
    list("materials", [](const Json& material) {
        return fmt::format(
            ", {}, {}", material["model"].get<std::string>(), material["alpha"].get<std::string>());
    });
    for (const char* count : {"textures", "skins"})
        line(count, std::to_string(info[count].get<std::size_t>()));
    line("lights", lights_text(info));
    if (info["cameras"].empty())
        line("cameras", "0: the whole scene is framed");
    else
        list("cameras", [](const Json& camera) {
            return fmt::format(", {:.4g} degrees", camera["fov_y_deg"].get<double>());
        });
    list("clips", [](const Json& clip) {
        return fmt::format(", {:.6g} s to {:.6g} s, {} frames", clip["begin_s"].get<double>(),
            clip["end_s"].get<double>(), clip["frames"].get<int>());
    });
    line(
        "bounds", vector_text(info["bounds"]["min"]) + " to " + vector_text(info["bounds"]["max"]));
    line("memory", fmt::format("{:.1f} MB", info["memory_bytes"].get<double>() / 1e6));
    std::string extensions;
    for (const Json& name : info["extensions"])
        extensions += (extensions.empty() ? "" : ", ") + name.get<std::string>();
    if (!extensions.empty()) line("extensions", extensions);
    line("warnings", std::to_string(info["warnings"].size()));
    return text;
}

int run_info(const InfoOptions& options)
{
    SceneSource source(options.scene);
    const std::shared_ptr<const Scene> scene = source.first();
    World world;
    pose(scene, pose_settings(options.scene.pose, *scene), world);
    Json info = describe(*scene, world, options.scene.shown_name());
    if (source.sequence().is_numbered()) info["sequence"] = describe(source.sequence());
    print(options.json ? to_text(info) : info_text(info));
    return kExitDone;
}

} // namespace firsthit::cli
