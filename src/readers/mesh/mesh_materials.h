// mesh_materials.h - the materials of a mesh file, from its libraries.
#pragma once

#include "readers/mesh/mtl/mtl_material.h"
#include "readers/mesh/raw_mesh.h"

#include <firsthit/scene_builder.h>

#include <filesystem>
#include <string>
#include <vector>

namespace firsthit {

/// Adds the materials of the file to the scene, in their order, and a grey one at the end; and textures and
/// the files of both. What cannot be had gets a warning and a plain colour: a library or texture that is
/// missing or damaged, a material that no library has.
///
/// name     of the mesh file, for messages
/// folder   where libraries and textures are; empty: they are not read
/// has_uv   false: textures are not read
/// returns  what the meshes of each material need, of the grey one too
std::vector<MtlMeshNeeds> read_materials(const RawMesh& raw, const std::string& name,
    const std::filesystem::path& folder, bool has_uv, SceneBuilder& scene);

} // namespace firsthit
