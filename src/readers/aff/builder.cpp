// builder.cpp - collects what the statements of an AFF scene make.
#include "readers/aff/builder.h"

#include <firsthit/error.h>

#include <algorithm>
#include <cstddef>

namespace firsthit::aff {
namespace {

bool same_times(const std::vector<MorphKey>& a, const std::vector<MorphKey>& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
        [](const MorphKey& p, const MorphKey& q) { return p.time_s == q.time_s; });
}

} // namespace

Builder::Builder(const AffFiles& files) : files_(files)
{
    scene.nodes.push_back({.name = "world"});
}

Part& Builder::add_part(const Lexer& lexer, std::uint32_t node, std::uint32_t material)
{
    Part part;
    part.name = lexer.file() + ":" + std::to_string(lexer.line());
    part.node = node;
    part.material = material;
    part.first_vertex = static_cast<std::uint32_t>(scene.position.size());
    part.first_triangle = static_cast<std::uint32_t>(scene.index.size());
    scene.parts.push_back(std::move(part));
    return scene.parts.back();
}

void Builder::begin_part(const Lexer& lexer, std::uint32_t node, std::uint32_t material)
{
    const Part* last = scene.parts.empty() ? nullptr : &scene.parts.back();
    if (last && last->node == node && last->material == material && last->morph.empty()) return;
    add_part(lexer, node, material);
}

std::uint32_t Builder::add_vertex(const glm::vec3& position, const glm::vec3& normal)
{
    const std::size_t number = scene.position.size();
    if (number >= kNoItem) throw SceneError(scene.name + ": more than 4294967295 vertices");
    scene.position.push_back(position);
    scene.normal.push_back(normal);
    ++scene.parts.back().vertex_count;
    return static_cast<std::uint32_t>(number);
}

std::uint32_t Builder::add_vertex(
    const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv)
{
    const std::uint32_t number = add_vertex(position, normal);
    scene.uv.resize(number, glm::vec2(0)); // those before that have none
    scene.uv.push_back(uv);
    return number;
}

void Builder::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
    if (scene.index.size() >= kNoItem)
        throw SceneError(scene.name + ": more than 4294967295 triangles");
    scene.index.emplace_back(a, b, c);
    scene.owner.push_back(static_cast<std::uint32_t>(scene.parts.size() - 1));
    ++scene.parts.back().triangle_count;
}

void Builder::add_morph_triangle(const Lexer& lexer, std::uint32_t node, std::uint32_t material,
    const std::vector<MorphKey>& keys)
{
    Part* part = scene.parts.empty() ? nullptr : &scene.parts.back();
    const bool joins = part && part->node == node && part->material == material &&
                       !part->morph.empty() && same_times(part->morph, keys);
    if (!joins) {
        part = &add_part(lexer, node, material);
        part->morph.resize(keys.size());
    }
    for (std::size_t k = 0; k < keys.size(); ++k) {
        MorphKey& to = part->morph[k];
        to.time_s = keys[k].time_s;
        to.position.insert(to.position.end(), keys[k].position.begin(), keys[k].position.end());
        to.normal.insert(to.normal.end(), keys[k].normal.begin(), keys[k].normal.end());
    }
    const std::uint32_t a = add_vertex(keys[0].position[0], keys[0].normal[0]);
    const std::uint32_t b = add_vertex(keys[0].position[1], keys[0].normal[1]);
    add_triangle(a, b, add_vertex(keys[0].position[2], keys[0].normal[2]));
}

std::uint32_t Builder::material(const std::string& name, const Phong& phong, std::int32_t texture)
{
    const Phong& m = phong;
    const std::array<float, 13> key = {m.ambient.x, m.ambient.y, m.ambient.z, m.diffuse.x,
        m.diffuse.y, m.diffuse.z, m.specular.x, m.specular.y, m.specular.z, m.shininess,
        m.transmittance, m.ior, static_cast<float>(texture)};
    const auto [entry, is_new] =
        materials_.try_emplace(key, static_cast<std::uint32_t>(scene.materials.size()));
    if (is_new) {
        Material& made = scene.materials.emplace_back();
        made.name = name;
        if (texture >= 0) made.name += " " + scene.textures[std::size_t(texture)].name();
        Phong& model = made.model.emplace<Phong>(phong);
        model.texture = texture;
    }
    return entry->second;
}

std::int32_t Builder::texture(const Lexer& lexer, std::string_view name)
{
    const auto [entry, is_new] = textures_.try_emplace(std::string(name), -1);
    if (!is_new) return entry->second;
    try {
        Texture texture = files_.texture(entry->first);
        texture.rename(entry->first);
        // AFF has v = 0 at a picture's first row, a scene at its last one.
        texture.turn_upside_down();
        scene.textures.push_back(std::move(texture));
        entry->second = static_cast<std::int32_t>(scene.textures.size() - 1);
    } catch (const FileError& error) {
        warn(lexer, "no texture " + in_quotes(name) + ", a plain colour instead: " + error.what());
    }
    return entry->second;
}

std::uint32_t Builder::add_node(Node node, std::string_view track)
{
    const auto number = static_cast<std::uint32_t>(scene.nodes.size());
    if (!track.empty()) node_tracks_.emplace_back(number, track);
    scene.nodes.push_back(std::move(node));
    return number;
}

void Builder::add_light(const Light& light, std::string_view track)
{
    if (!track.empty()) light_tracks_.emplace_back(scene.lights.size(), track);
    scene.lights.push_back(light);
}

Track& Builder::begin_track(std::string_view name)
{
    const auto [entry, is_new] =
        tracks_.try_emplace(std::string(name), static_cast<std::int32_t>(scene.tracks.size()));
    if (is_new) scene.tracks.emplace_back();
    Track& track = scene.tracks[static_cast<std::size_t>(entry->second)];
    track = Track{};
    track.name = entry->first;
    return track;
}

void Builder::warn(const Lexer& lexer, const std::string& message)
{
    scene.warnings.push_back(lexer.place() + message);
}

std::int32_t Builder::track_named(const std::string& name) const
{
    const auto entry = tracks_.find(name);
    return entry == tracks_.end() ? -1 : entry->second;
}

Scene Builder::finish()
{
    for (const auto& [node, name] : node_tracks_) scene.nodes[node].track = track_named(name);
    for (const auto& [light, name] : light_tracks_) scene.lights[light].track = track_named(name);
    scene.camera_track = track_named("camera");
    scene.vertices = scene.position.size();
    if (!scene.uv.empty()) scene.uv.resize(scene.vertices, glm::vec2(0));
    return std::move(scene);
}

} // namespace firsthit::aff
