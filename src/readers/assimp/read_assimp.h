// read_assimp.h - FBX, COLLADA and 3MF files as scenes, by the library Assimp.
#pragma once

#include <firsthit/scene.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace firsthit {

/// Whether Assimp reads files with that ending: ".fbx", ".dae", ".3mf".
bool is_assimp_extension(std::string_view extension);

/// Reads nodes, meshes with skins and morph targets, clips, materials, textures, cameras and lights. Lengths
/// become metres and y becomes up, by what the file says.
///
/// throws  FileError: missing, unreadable, malformed; or the build has no Assimp
///         SceneError: a coordinate that is not finite, more than memory should hold
Scene read_assimp(const std::filesystem::path& path, const LoadSettings& settings);

/// The same from memory.
///
/// name       of the file, for messages
/// extension  of the format
/// folder     where textures are; empty: no other file is read
Scene read_assimp(const std::string& name, const std::string& bytes, const std::string& extension,
    const std::filesystem::path& folder, const LoadSettings& settings);

} // namespace firsthit
