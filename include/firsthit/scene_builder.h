// scene_builder.h - puts a scene together from nodes, meshes, instances, materials and so on.
#pragma once

#include <firsthit/scene.h>

#include <cstdint>
#include <string>
#include <vector>

namespace firsthit {

/// Puts a scene together. What is added gets a number, from 0 in order of the calls, by which others
/// name it. Nothing is checked before build().
///
///     SceneBuilder builder("two boxes");
///     const std::uint32_t box = builder.add_mesh(std::move(mesh));
///     const std::uint32_t paint = builder.add_material({.name = "paint"});
///     builder.add_instance(box, builder.add_node({.name = "left"}), paint);
///     builder.add_instance(box, builder.add_node({.name = "right"}), paint);
///     const auto scene = std::make_shared<const Scene>(builder.build());
class SceneBuilder {
  public:
    /// name  of the scene, for messages
    explicit SceneBuilder(std::string name) { scene_.name = std::move(name); }

    /// Its parent was added before, or is -1.
    std::uint32_t add_node(Node node);
    /// A clip of Scene::clips.
    std::uint32_t add_clip(Clip clip);
    /// A channel of the clip that was added last. No clip yet: an unnamed one is added.
    void add_channel(Channel channel);
    /// The joints of meshes.
    std::uint32_t add_skin(Skin skin);
    /// A material of instances.
    std::uint32_t add_material(Material material);
    /// A texture of materials.
    std::uint32_t add_texture(Texture texture);
    /// A light; in the space of its node.
    std::uint32_t add_light(Light light);
    /// A camera; in the space of its node.
    std::uint32_t add_camera(SceneCamera camera);
    /// A mesh, which is seen where it has instances.
    std::uint32_t add_mesh(Mesh mesh);

    /// Places a mesh. Triangle ids are in order of the instances.
    ///
    /// skin  moves the mesh in the place of the node; -1: none
    /// name  of the instance; empty: the node's
    void add_instance(std::uint32_t mesh, std::uint32_t node, std::uint32_t material,
        std::int32_t skin = -1, std::string name = {});

    /// Sets where nothing is seen: linear Rec.709.
    void set_background(const glm::vec3& color) { scene_.background = color; }
    /// Sets what multiplies every material's ambient colour.
    void set_ambient(const glm::vec3& color) { scene_.ambient = color; }
    /// Sets the pixels that the file asks for.
    void set_picture_size(const glm::ivec2& size) { scene_.picture_size = size; }
    /// Adds a line to Scene::warnings.
    void warn(std::string warning) { scene_.warnings.push_back(std::move(warning)); }
    /// Sets Scene::extensions.
    void set_extensions(std::vector<std::string> names) { scene_.extensions = std::move(names); }
    /// Adds to Scene::files what is not there yet.
    void add_file(std::string path);

    /// Gives the scene away; the builder must not be used any more.
    /// throws  SceneError: a number out of range, a coordinate that is not finite, arrays that do not fit
    Scene build();

  private:
    struct Placed {
        std::uint32_t mesh, node, material;
        std::int32_t skin;
        std::string name;
    };
    void append(const Placed& placed, bool last_use);

    Scene scene_;
    std::vector<Mesh> meshes_;
    std::vector<Placed> placed_;
    std::vector<std::int32_t> shape_;  // (meshes) of Scene::shapes; -1: none
    std::vector<std::uint8_t> facets_; // (meshes) whether every pose makes its normals anew
};

} // namespace firsthit
