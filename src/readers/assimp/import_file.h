// import_file.h - a file's bytes through Assimp.
#pragma once

#include <assimp/Importer.hpp>
#include <assimp/scene.h>

#include <filesystem>
#include <memory>
#include <string>

namespace firsthit {

/// A file as Assimp understands it; `scene` belongs to the importer.
struct ImportedFile {
    std::unique_ptr<Assimp::Importer> importer;
    const aiScene* scene = nullptr;
};

/// Imports a file. Faces are triangles, vertices are welded, missing normals are made, and only the reader of
/// that ending is asked. Assimp opens no other file than the one it is given. It is first tried in a child process.
///
/// name              for messages
/// crease_angle_rad  of normals that are made
/// throws            FileError: what Assimp says
ImportedFile import_file(const std::string& name, const std::string& bytes,
    const std::string& extension, double crease_angle_rad);

} // namespace firsthit
