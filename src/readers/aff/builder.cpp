// builder.cpp - collects what the statements of an AFF scene make.
#include "readers/aff/builder.h"

#include <firsthit/error.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace firsthit::aff {
namespace {

bool same_times(const std::vector<MorphKey>& a, const std::vector<MorphKey>& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
        [](const MorphKey& p, const MorphKey& q) { return p.time_s == q.time_s; });
}

} // namespace

Builder::Builder(const AffFiles& files, const std::string& name)
    : scene(name),
      files_(files),
      name_(name)
{
    nodes_.push_back({.name = "world"});
}

Builder::Part& Builder::add_part(const Lexer& lexer, std::uint32_t node, std::uint32_t material)
{
    return parts_.emplace_back(Part{.place = lexer.file() + ":" + std::to_string(lexer.line()),
        .node = node,
        .material = material,
        .first_vertex = vertices()});
}

void Builder::begin_instance(const Lexer& lexer, std::uint32_t node, std::uint32_t material)
{
    const Part* last = parts_.empty() ? nullptr : &parts_.back();
    if (last && last->node == node && last->material == material && last->mesh.keys.empty()) return;
    add_part(lexer, node, material);
}

std::uint32_t Builder::vertices() const
{
    if (parts_.empty()) return 0;
    const Part& last = parts_.back();
    return last.first_vertex + static_cast<std::uint32_t>(last.mesh.position.size());
}

bool Builder::has_triangles() const
{
    return std::any_of(
        parts_.begin(), parts_.end(), [](const Part& part) { return !part.mesh.index.empty(); });
}

std::uint32_t Builder::add_vertex(const glm::vec3& position, const glm::vec3& normal)
{
    const std::uint32_t number = vertices();
    if (number >= kNoItem) throw SceneError(name_ + ": more than 4294967295 vertices");
    parts_.back().mesh.position.push_back(position);
    parts_.back().mesh.normal.push_back(normal);
    return number;
}

std::uint32_t Builder::add_vertex(
    const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv)
{
    const std::uint32_t number = add_vertex(position, normal);
    Mesh& mesh = parts_.back().mesh;
    mesh.uv.resize(mesh.position.size() - 1, glm::vec2(0)); // those before that have none
    mesh.uv.push_back(uv);
    return number;
}

void Builder::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
    Part& part = parts_.back();
    part.mesh.index.emplace_back(
        a - part.first_vertex, b - part.first_vertex, c - part.first_vertex);
}

void Builder::add_morph_triangle(const Lexer& lexer, std::uint32_t node, std::uint32_t material,
    const std::vector<MorphKey>& keys)
{
    Part* part = parts_.empty() ? nullptr : &parts_.back();
    const bool joins = part && part->node == node && part->material == material &&
                       !part->mesh.keys.empty() && same_times(part->mesh.keys, keys);
    if (!joins) {
        part = &add_part(lexer, node, material);
        part->mesh.keys.resize(keys.size());
    }
    for (std::size_t k = 0; k < keys.size(); ++k) {
        MorphKey& to = part->mesh.keys[k];
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
    const auto [entry, is_new] = materials_.try_emplace(key, 0u);
    if (is_new) {
        Material made;
        made.name = name;
        if (texture >= 0) made.name += " " + texture_names_[std::size_t(texture)];
        Phong& model = made.model.emplace<Phong>(phong);
        model.texture = texture;
        entry->second = scene.add_material(std::move(made));
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
        entry->second = static_cast<std::int32_t>(scene.add_texture(std::move(texture)));
        texture_names_.push_back(entry->first);
    } catch (const FileError& error) {
        warn(lexer, "no texture " + in_quotes(name) + ", a plain colour instead: " + error.what());
    }
    return entry->second;
}

std::uint32_t Builder::add_node(Node node, std::string_view track)
{
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    if (!track.empty()) node_tracks_.emplace_back(number, track);
    nodes_.push_back(std::move(node));
    return number;
}

void Builder::add_light(const Light& light, std::string_view track)
{
    if (!track.empty()) light_tracks_.emplace_back(lights_.size(), track);
    lights_.push_back(light);
}

Track& Builder::begin_track(std::string_view name)
{
    Track& track = tracks_[std::string(name)];
    track = Track{};
    track.name = name;
    return track;
}

void Builder::warn(const Lexer& lexer, const std::string& message)
{
    scene.warn(lexer.place() + message);
}

const Track* Builder::track_named(const std::string& name) const
{
    const auto entry = tracks_.find(name);
    return entry == tracks_.end() ? nullptr : &entry->second;
}

/// A node of the world for what is no node in AFF: a light, the camera.
///
/// rest  where it is as far as the track does not move it
std::uint32_t Builder::track_node(const Track& track, NodeTransform rest)
{
    const NodeTransform begin = transform_at(track, clip.begin_s);
    if (!track.translation.empty()) rest.translation = begin.translation;
    if (!track.rotation.empty()) rest.rotation = begin.rotation;
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({.name = track.name, .transform = rest});
    return number;
}

/// The camera is where the track `camera` moves it and looks along -z of the track's rotation; what the
/// track lacks stays as the file's `v` says.
void Builder::add_camera()
{
    const Track* track = track_named("camera");
    if (!camera && !track) return;
    SceneCamera made{.name = "camera", .camera = camera.value_or(Camera{})};
    if (track) {
        Track moves = *track; // its scale and visibility are no camera's
        moves.scale.clear();
        moves.visibility.clear();
        made.node = static_cast<std::int32_t>(track_node(moves, {.translation = made.camera.eye}));
        add_channels(moves, static_cast<std::uint32_t>(made.node), clip);
        made.camera.eye = glm::dvec3(0);
        if (!moves.rotation.empty()) {
            made.camera.direction = {0, 0, -1};
            made.camera.up = {0, 1, 0};
        }
    }
    scene.add_camera(std::move(made));
}

Scene Builder::finish()
{
    for (const auto& [node, name] : node_tracks_) {
        const Track* track = track_named(name);
        if (!track) continue;
        nodes_[node].transform = transform_at(*track, clip.begin_s);
        add_channels(*track, node, clip);
    }
    for (const auto& [number, name] : light_tracks_) {
        const Track* track = track_named(name);
        if (!track || track->translation.empty()) continue;
        const Track moves{.name = name, .translation = track->translation};
        Light& light = lights_[number];
        light.node = static_cast<std::int32_t>(track_node(moves, {}));
        light.position = glm::dvec3(0);
        add_channels(moves, static_cast<std::uint32_t>(light.node), clip);
    }
    add_camera();
    bool morphs = false;
    for (Part& part : parts_) {
        morphs = morphs || !part.mesh.keys.empty();
        scene.add_instance(
            scene.add_mesh(std::move(part.mesh)), part.node, part.material, -1, part.place);
    }
    for (Node& node : nodes_) scene.add_node(std::move(node));
    for (Light& light : lights_) scene.add_light(std::move(light));
    if (morphs || !clip.channels.empty() || clip.end_s > clip.begin_s || clip.frames > 1 ||
        clip.begin_s != 0)
        scene.add_clip(std::move(clip));
    for (std::string& warning : problems.lines(name_)) scene.warn(std::move(warning));
    return scene.build();
}

} // namespace firsthit::aff
