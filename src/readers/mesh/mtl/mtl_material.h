// mtl_material.h - materials of libraries as materials of a scene.
#pragma once

#include "readers/mesh/mtl/mtl.h"
#include "readers/mesh/mtl/mtl_textures.h"

#include <firsthit/material.h>
#include <firsthit/mesh.h>

#include <glm/mat3x2.hpp>

namespace firsthit {

/// What a mesh needs to get its material: texture coordinates changed for a texture that cannot change them
/// itself, and tangents for a map of normals.
struct MtlMeshNeeds {
    glm::mat3x2 uv_transform{1.0f};
    bool tangents = false;
    glm::mat3x2 normal_transform{1.0f}; // of the map of normals

    /// Changes a mesh accordingly.
    void apply(Mesh& mesh) const;
};

/// How all materials of a file are made. One model for all, as a light of one strength is too bright or too dark
/// for one of two: MetallicRoughness where a material of the file asks for it, else Phong.
struct MtlSettings {
    bool physical = false;
    bool has_uv = false;     // else textures are not read
    bool has_colors = false; // of vertices, which show on white where there is no material
};

/// Makes a material.
///
/// Phong: Ka, Kd, Ks, Ns as they are, and Ke as ambient light under the usual Scene::ambient of mesh
/// files. MetallicRoughness: Kd is the base colour, Pr and Pm are as they say; without Pr the
/// roughness is that of Phong's exponent Ns by r^4 = 2 / (Ns + 2), without Pm it is no metal.
/// Opacity less than 0.998 is blended; a map_d is a mask where its picture nearly is one, and else
/// blended too.
///
/// needs  what the meshes of that material need
Material make_material(const MtlMaterial& mtl, const MtlSettings& settings, MtlTextures& textures,
    MtlMeshNeeds& needs);

/// The same for the material of a mesh without one.
Material make_default_material(const MtlSettings& settings);

} // namespace firsthit
