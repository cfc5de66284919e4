// scene_maker.h - makes a scene of a glTF document.
#pragma once

#include "readers/gltf/document/document.h"

#include <firsthit/scene_builder.h>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace firsthit::gltf {

/// A scene has at most so many vertices, or triangles, more than the document's accessors have elements:
/// instances that repeat a mesh, or primitives that share accessors, cannot take all memory.
inline constexpr std::size_t kMostRepeated = std::size_t(1) << 24;

/// At most so many instances come from EXT_mesh_gpu_instancing.
inline constexpr std::size_t kMostInstancedNodes = std::size_t(1) << 20;

/// Goes through a document and adds what it finds to a scene. `scene` is the number of one of its scenes, or
/// kNone: all roots. Each part of the work is in a file of its own.
class SceneMaker {
  public:
    SceneMaker(const Document& document, int scene);

    Scene make();

  private:
    // scene_maker.cpp: nodes, and what hangs on them
    void add_tree(int root, bool visible);
    void add_node(int node, bool visible);
    void add_light(int node);
    void add_camera(int node);
    void warn_once(const std::string& warning);

    // instances.cpp: meshes where nodes place them
    void add_instances(int node);
    void add_primitives(int node, std::uint32_t scene_node);
    std::int32_t mesh_of(int mesh, int primitive, int skin);

    // skins.cpp
    void add_skins();
    std::uint32_t identity_node();

    // clips.cpp
    void add_clips();
    void add_channel(const Animation& animation, const AnimationChannel& channel, Clip& clip);

    // materials.cpp
    std::uint32_t material_of(int material);
    TextureRef texture_of(const TextureInfo& info, Encoding encoding = Encoding::srgb);
    TextureRef place_of(const TextureInfo& info);
    std::int32_t add_texture(int texture, Encoding encoding);
    std::optional<Picture> decode(int texture);
    std::int32_t add_picture(int texture, const Picture& picture, Encoding encoding);
    void warn_of_missing(const Material& material);
    void add_tangents(const Primitive& primitive, firsthit::Mesh& mesh);

    // material_model.cpp
    Unlit unlit_of(const Material& material);
    MetallicRoughness model_of(const Material& material);
    void add_specular(const Specular& specular, MetallicRoughness& model);
    void add_specular_glossiness(const SpecularGlossiness& from, MetallicRoughness& model);

    const Document& document_;
    SceneBuilder builder_;
    std::vector<int> roots_;
    std::vector<std::int32_t> scene_node_; // (nodes) their number in the scene; -1: none yet
    std::vector<std::uint8_t>
        needs_identity_;                 // (skins) whether vertices without weights need a joint
    std::int32_t identity_node_ = -1;    // of that joint; -1: none yet
    std::vector<std::int32_t> material_; // (materials + 1) in the scene; -1: none yet
    /// By image, wraps and filter, encoding; -1: cannot be shown.
    std::map<std::tuple<int, Wrap, Wrap, bool, Encoding>, std::int32_t> texture_;
    /// By texture and glossiness: the colours and the roughness of a specular-glossiness texture.
    std::map<std::pair<int, float>, std::pair<std::int32_t, std::int32_t>> glossy_;
    std::map<std::tuple<int, int, int>, std::int32_t>
        mesh_;                          // by mesh, primitive, skin; -1: not shown
    std::vector<std::size_t> size_;     // (meshes of the scene) vertices or triangles, what is more
    std::size_t room_;                  // how much more of them may be placed
    std::size_t instanced_nodes_ = 0;   // by EXT_mesh_gpu_instancing
    std::optional<std::string> unread_; // why the first mesh that should be there could not be read
    std::set<std::string> warned_;
};

/// A primitive's vertices and triangles.
///
/// skin_joints     how many joints the skin has; 0: JOINTS and WEIGHTS are not read
/// identity_joint  set where a vertex has no weight: the joint after the last, which moves nothing
/// throws          FileError, SceneError: as accessors.h says
firsthit::Mesh read_primitive(const Document& document, const Mesh& mesh,
    const Primitive& primitive, std::size_t skin_joints, bool& identity_joint);

/// Triangles of a list of corners: as they come, or as a strip or a fan. A rest of fewer than three is
/// left out. The mode is one of triangles.
std::vector<glm::uvec3> triangles_of(PrimitiveMode mode, const std::vector<std::uint32_t>& corners);

} // namespace firsthit::gltf
