// imported_scene.h - makes a scene of what Assimp has read.
#pragma once

#include "readers/assimp/imported_materials.h"

#include <firsthit/scene_builder.h>

#include <assimp/scene.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

namespace firsthit {

/// Goes through what Assimp has read and adds it to a scene. Each part of the work is in a file of its own.
class ImportedScene {
  public:
    /// name       of the file, for messages
    /// extension  of the file: units and axes are said in another way in each format
    /// folder     where textures are; empty: they are not read
    /// unit_m     metres of one unit, of a 3MF file
    ImportedScene(const aiScene& from, std::string name, std::string extension,
        const std::filesystem::path& folder, double unit_m);

    /// throws  as read_assimp
    Scene make();

  private:
    // imported_scene.cpp
    glm::dmat4 world_from_file() const;
    void add_nodes();
    void add_instances();
    void warn_once(const std::string& warning);
    /// The scene's node of a name; -1: none.
    std::int32_t node_named(const aiString& name) const;

    // imported_meshes.cpp
    std::uint32_t mesh_of(unsigned mesh);
    std::int32_t skin_of(unsigned mesh, std::uint32_t node);

    // imported_views.cpp
    void add_cameras();
    void add_lights();

    // imported_clips.cpp
    void add_clips();

    struct PlacedNode {
        const aiNode* from;
        std::uint32_t number; // in the scene
    };

    const aiScene& from_;
    std::string name_;
    std::string extension_;
    double unit_m_;
    SceneBuilder builder_;
    ImportedMaterials materials_;
    std::vector<PlacedNode> nodes_;
    std::unordered_map<std::string, std::uint32_t> node_; // by name, the first
    std::vector<std::int64_t> mesh_;                      // (meshes) in the scene; -1: none yet
    std::set<std::string> warned_;
};

/// A mesh's vertices, triangles and morph targets, and how they follow the joints of its bones. Vertices that
/// no bone moves follow one more joint, the last.
/// throws  SceneError: an index out of range
Mesh mesh_of(const aiMesh& from, const std::string& name);

} // namespace firsthit
