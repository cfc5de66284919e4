// mesh_materials.h - the materials of a mesh file, from its libraries.
#pragma once

#include "readers/mesh/raw_mesh.h"

#include <firsthit/scene.h>

#include <filesystem>
#include <string>

namespace firsthit {

/// Fills the scene's materials with those of the file, in their order, and a grey one at the end;
/// and its textures; adds the files of both to the scene's. What cannot be had gets a warning and a plain colour: a library or texture
/// that is missing, a material that no library has.
///
/// name    of the mesh file, for messages
/// folder  where libraries and textures are; empty: they are not read
/// has_uv  false: textures are not read
/// throws  FileError, SceneError: a library that is there but malformed
void read_materials(const RawMesh& raw, const std::string& name,
    const std::filesystem::path& folder, bool has_uv, Scene& scene);

} // namespace firsthit
