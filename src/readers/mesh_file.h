// mesh_file.h - PLY, STL, OBJ and OFF files as scenes.
#pragma once

#include <firsthit/scene.h>

#include <filesystem>
#include <string>
#include <vector>

namespace firsthit {

/// Reads a .ply, .stl, .obj or .off file, ascii or binary: one node, a part for each run of triangles
/// with the same material, no lights and no camera.
///
/// Triangle ids are the file's order; a face of n corners is a fan of n - 2 triangles around its
/// first corner; triangles without area keep their id. Points, lines and faces of fewer than three
/// corners are left out with a warning. Vertices with equal position, normal and texture
/// coordinates are one; vertices that no triangle uses are left out. Where a file has no normals
/// they are made smooth (see mesh/smooth_normals.h); those of STL facets are not used. v of the
/// texture coordinates counts from the picture's bottom, as in these files.
///
/// corners  where not null: see read_scene.h
/// throws   FileError: missing, unreadable, malformed (names file and line or element)
///          SceneError: an index out of range, a coordinate that is not finite
Scene read_mesh_file(const std::filesystem::path& path, const LoadSettings& settings,
    std::vector<glm::uvec3>* corners = nullptr);

/// The same from memory.
///
/// bytes      the file; freed on the way
/// extension  ".ply", ".stl", ".obj" or ".off"
/// name       of the file, for messages
/// folder     where material libraries and textures are; empty: they are not read
/// returns    the scene, whose files are the libraries and textures
Scene read_mesh(std::string bytes, const std::string& extension, const std::string& name,
    const std::filesystem::path& folder, const LoadSettings& settings);

} // namespace firsthit
