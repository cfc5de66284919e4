// assimp_mesh.cpp - reads the triangles of a checked mesh file with Assimp.
#include "readers/mesh/assimp_mesh.h"

#include <firsthit/error.h>

#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <fmt/format.h>

namespace firsthit {
namespace {

glm::vec3 to_glm(const aiVector3D& v)
{
    return {v.x, v.y, v.z};
}

void append_mesh(const aiMesh& mesh, bool keep_normals, const std::string& name, RawMesh& raw)
{
    const auto base = static_cast<std::uint32_t>(raw.position.size());
    for (unsigned v = 0; v < mesh.mNumVertices; ++v)
        raw.position.push_back(to_glm(mesh.mVertices[v]));
    if (keep_normals && mesh.HasNormals()) {
        raw.normal.resize(base, glm::vec3(0));
        for (unsigned v = 0; v < mesh.mNumVertices; ++v)
            raw.normal.push_back(to_glm(mesh.mNormals[v]));
    }
    if (mesh.HasTextureCoords(0)) {
        raw.uv.resize(base, glm::vec2(0));
        for (unsigned v = 0; v < mesh.mNumVertices; ++v)
            raw.uv.emplace_back(mesh.mTextureCoords[0][v].x, mesh.mTextureCoords[0][v].y);
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        const aiFace& face = mesh.mFaces[f];
        for (unsigned k = 0; k < face.mNumIndices; ++k)
            if (face.mIndices[k] >= mesh.mNumVertices)
                throw FileError(fmt::format("{}: Assimp misread face {}", name, f));
        for (unsigned k = 2; k < face.mNumIndices; ++k)
            raw.index.emplace_back(
                base + face.mIndices[0], base + face.mIndices[k - 1], base + face.mIndices[k]);
    }
}

} // namespace

RawMesh read_with_assimp(
    CheckedMesh& checked, const std::string& extension, const std::string& name)
{
    // What is written for Assimp can be longer than the file.
    if (checked.bytes.size() > kMaxMeshFile)
        throw FileError(fmt::format("{}: {} bytes after the check, at most {} are accepted", name,
            checked.bytes.size(), kMaxMeshFile));

    // No post-processing: it would reorder faces.
    Assimp::Importer importer;
    const aiScene* const scene = importer.ReadFileFromMemory(
        checked.bytes.data(), checked.bytes.size(), 0, extension.c_str() + 1);
    if (scene == nullptr) throw FileError(fmt::format("{}: {}", name, importer.GetErrorString()));
    checked.bytes = std::string();

    RawMesh raw;
    std::size_t vertices = 0;
    for (unsigned m = 0; m < scene->mNumMeshes; ++m) vertices += scene->mMeshes[m]->mNumVertices;
    raw.position.reserve(vertices);
    raw.index.reserve(checked.triangle_count);
    // STL's normals are those of the facets.
    const bool keep_normals = extension != ".stl";
    for (unsigned m = 0; m < scene->mNumMeshes; ++m)
        append_mesh(*scene->mMeshes[m], keep_normals, name, raw);
    if (!raw.normal.empty()) raw.normal.resize(raw.position.size(), glm::vec3(0));
    if (!raw.uv.empty()) raw.uv.resize(raw.position.size(), glm::vec2(0));

    if (raw.index.size() != checked.triangle_count)
        throw FileError(fmt::format(
            "{}: Assimp reads {} of {} triangles", name, raw.index.size(), checked.triangle_count));
    return raw;
}

} // namespace firsthit
