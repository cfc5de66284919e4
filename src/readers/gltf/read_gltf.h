// read_gltf.h - glTF 2.0 files as scenes.
#pragma once

#include <firsthit/scene.h>

#include <filesystem>
#include <string>

namespace firsthit {

/// Reads a .gltf or .glb file. Triangle ids number the triangles depth first from the roots of the scene, a
/// node before its children; of a node instance by instance, each with its primitives in order; strips
/// and fans in the order of the specification. Points and lines are left out with a warning.
///
/// limits  those of read_document; at most 2^24 vertices or triangles more than the accessors have
///         elements; at most 2^20 instances by EXT_mesh_gpu_instancing
/// throws  FileError: missing, malformed, or it requires an extension that is unknown
///         SceneError: an index out of range, a coordinate that is not finite, a limit
///         ArgumentError: settings.scene names no scene of the file
Scene read_gltf(const std::filesystem::path& path, const LoadSettings& settings);

/// The same from memory.
///
/// name    of the file, for messages
/// folder  where buffers and images are; empty: they are not read
Scene read_gltf(const std::string& name, std::string bytes, const std::filesystem::path& folder,
    const LoadSettings& settings);

} // namespace firsthit
