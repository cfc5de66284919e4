// scene_builder.cpp - puts a scene together.
#include <firsthit/scene_builder.h>

#include "scene/model/check_scene.h"
#include "scene/model/facets.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace firsthit {
namespace {

template <class T>
std::uint32_t add_to(std::vector<T>& list, T&& value)
{
    list.push_back(std::forward<T>(value));
    return static_cast<std::uint32_t>(list.size() - 1);
}

std::size_t vertices_of(const Mesh& mesh)
{
    return mesh.position.empty() ? mesh.vertices : mesh.position.size();
}

bool changes_shape(const Mesh& mesh)
{
    return !mesh.shape.targets.empty() || mesh.shape.skin.influences > 0;
}

/// What the copying of meshes relies on, before check_scene can see them.
void check_mesh(const std::string& scene, std::size_t number, const Mesh& mesh)
{
    const auto fail = [&](const std::string& what) {
        throw SceneError(fmt::format("{}: mesh {} '{}': {}", scene, number, mesh.shape.name, what));
    };
    const std::size_t vertices = vertices_of(mesh);
    const auto check = [&](std::size_t size, const char* what) {
        if (size != 0 && size != vertices)
            fail(fmt::format("{} {} for {} vertices", size, what, vertices));
    };
    check(mesh.normal.size(), "normals");
    check(mesh.uv.size(), "texture coordinates");
    check(mesh.uv1.size(), "second texture coordinates");
    check(mesh.color.size(), "vertex colours");
    check(mesh.tangent.size(), "tangents");
    for (const MorphTarget& target : mesh.shape.targets) {
        check(target.position.size(), "displacements of a morph target");
        check(target.normal.size(), "displacements of a morph target's normals");
        check(target.tangent.size(), "displacements of a morph target's tangents");
    }
    const SkinWeights& skin = mesh.shape.skin;
    if (skin.influences < 0 ||
        skin.joint.size() != vertices * static_cast<std::size_t>(skin.influences) ||
        skin.weight.size() != skin.joint.size())
        fail(fmt::format("{} joints and {} weights for {} vertices with {} influences",
            skin.joint.size(), skin.weight.size(), vertices, skin.influences));
    for (std::size_t t = 0; t < mesh.index.size(); ++t)
        for (int k = 0; k < 3; ++k)
            if (mesh.index[t][k] >= vertices)
                fail(fmt::format("triangle {}: vertex {} is out of range ({} vertices)", t,
                    mesh.index[t][k], vertices));
    if (mesh.normal.empty() && !mesh.deform && mesh.index.size() > kNoItem / 3)
        fail(fmt::format("{} triangles without normals, at most {} are accepted", mesh.index.size(),
            kNoItem / 3));
}

/// Appends the values of one instance's vertices. Those before that have none get `missing`.
template <class T>
void append_values(
    std::vector<T>& to, std::size_t first, std::vector<T>& from, bool last_use, const T& missing)
{
    if (from.empty()) return;
    if (first == 0 && last_use) {
        to = std::move(from);
        return;
    }
    to.resize(first, missing);
    to.insert(to.end(), from.begin(), from.end());
}

/// The last vertices may have no value of a kind of which others have.
template <class T>
void complete(std::vector<T>& values, std::size_t vertices, const T& missing)
{
    if (!values.empty()) values.resize(vertices, missing);
}

} // namespace

std::uint32_t SceneBuilder::add_node(Node node)
{
    return add_to(scene_.nodes, std::move(node));
}

std::uint32_t SceneBuilder::add_clip(Clip clip)
{
    return add_to(scene_.clips, std::move(clip));
}

void SceneBuilder::add_channel(Channel channel)
{
    if (scene_.clips.empty()) scene_.clips.emplace_back();
    scene_.clips.back().channels.push_back(std::move(channel));
}

std::uint32_t SceneBuilder::add_skin(Skin skin)
{
    return add_to(scene_.skins, std::move(skin));
}

std::uint32_t SceneBuilder::add_material(Material material)
{
    return add_to(scene_.materials, std::move(material));
}

std::uint32_t SceneBuilder::add_texture(Texture texture)
{
    return add_to(scene_.textures, std::move(texture));
}

std::uint32_t SceneBuilder::add_light(Light light)
{
    return add_to(scene_.lights, std::move(light));
}

std::uint32_t SceneBuilder::add_camera(SceneCamera camera)
{
    return add_to(scene_.cameras, std::move(camera));
}

std::uint32_t SceneBuilder::add_mesh(Mesh mesh)
{
    return add_to(meshes_, std::move(mesh));
}

void SceneBuilder::add_instance(std::uint32_t mesh, std::uint32_t node, std::uint32_t material,
    std::int32_t skin, std::string name)
{
    placed_.push_back({mesh, node, material, skin, std::move(name)});
}

void SceneBuilder::add_file(std::string path)
{
    std::vector<std::string>& files = scene_.files;
    if (std::find(files.begin(), files.end(), path) == files.end())
        files.push_back(std::move(path));
}

void SceneBuilder::append(const Placed& placed, bool last_use)
{
    Mesh& mesh = meshes_[placed.mesh];
    const std::size_t first = scene_.vertices;
    const std::size_t vertices = vertices_of(mesh);

    Instance& instance = scene_.instances.emplace_back();
    instance.name = placed.name.empty() ? scene_.nodes[placed.node].name : placed.name;
    instance.node = placed.node;
    instance.material = placed.material;
    instance.first_vertex = static_cast<std::uint32_t>(first);
    instance.vertex_count = static_cast<std::uint32_t>(vertices);
    instance.first_triangle = static_cast<std::uint32_t>(scene_.index.size());
    instance.triangle_count = static_cast<std::uint32_t>(mesh.index.size());
    instance.skin = placed.skin;
    instance.shape = shape_[placed.mesh];
    instance.facet_normals = facets_[placed.mesh] != 0;
    instance.deform = mesh.deform;
    instance.morph = last_use ? std::move(mesh.keys) : mesh.keys;

    append_values(scene_.position, first, mesh.position, last_use, glm::vec3(0));
    append_values(scene_.normal, first, mesh.normal, last_use, glm::vec3(0, 0, 1));
    append_values(scene_.uv, first, mesh.uv, last_use, glm::vec2(0));
    append_values(scene_.uv1, first, mesh.uv1, last_use, glm::vec2(0));
    append_values(scene_.color, first, mesh.color, last_use, glm::vec4(1));
    append_values(scene_.tangent, first, mesh.tangent, last_use, glm::vec4(1, 0, 0, 1));
    if (first == 0 && last_use) {
        scene_.index = std::move(mesh.index);
    } else {
        const auto shift = static_cast<std::uint32_t>(first);
        for (const glm::uvec3& corners : mesh.index) scene_.index.push_back(corners + shift);
    }
    scene_.owner.resize(
        scene_.index.size(), static_cast<std::uint32_t>(scene_.instances.size() - 1));
    scene_.vertices += vertices;
    if (last_use) mesh = {};
}

Scene SceneBuilder::build()
{
    std::vector<std::size_t> uses(meshes_.size(), 0);
    std::size_t vertices = 0, triangles = 0;
    for (const Placed& placed : placed_) {
        const auto check = [&](std::uint32_t number, std::size_t count, const char* what) {
            if (number >= count)
                throw SceneError(fmt::format("{}: an instance's {} {} is out of range ({})",
                    scene_.name, what, number, count));
        };
        check(placed.mesh, meshes_.size(), "mesh");
        check(placed.node, scene_.nodes.size(), "node");
        ++uses[placed.mesh];
    }
    shape_.assign(meshes_.size(), -1);
    facets_.assign(meshes_.size(), 0);
    for (std::size_t m = 0; m < meshes_.size(); ++m) {
        Mesh& mesh = meshes_[m];
        if (uses[m] == 0) continue;
        check_mesh(scene_.name, m, mesh);
        if (mesh.normal.empty() && !mesh.deform) {
            make_facets(mesh);
            facets_[m] = changes_shape(mesh);
        }
        if (changes_shape(mesh))
            shape_[m] = static_cast<std::int32_t>(add_to(scene_.shapes, std::move(mesh.shape)));
        vertices += uses[m] * vertices_of(mesh);
        triangles += uses[m] * mesh.index.size();
    }
    if (vertices > kNoItem)
        throw SceneError(fmt::format("{}: more than {} vertices", scene_.name, kNoItem));
    if (triangles >= kNoItem)
        throw SceneError(fmt::format("{}: more than {} triangles", scene_.name, kNoItem - 1));
    if (placed_.size() > 1) {
        scene_.index.reserve(triangles);
        scene_.position.reserve(vertices);
        scene_.normal.reserve(vertices);
    }
    scene_.owner.reserve(triangles);
    for (const Placed& placed : placed_) append(placed, --uses[placed.mesh] == 0);
    complete(scene_.position, scene_.vertices, glm::vec3(0));
    complete(scene_.normal, scene_.vertices, glm::vec3(0, 0, 1));
    complete(scene_.uv, scene_.vertices, glm::vec2(0));
    complete(scene_.uv1, scene_.vertices, glm::vec2(0));
    complete(scene_.color, scene_.vertices, glm::vec4(1));
    complete(scene_.tangent, scene_.vertices, glm::vec4(1, 0, 0, 1));
    check_scene(scene_);
    return std::move(scene_);
}

} // namespace firsthit
