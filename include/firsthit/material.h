// material.h - what a surface is made of.
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <string>
#include <variant>

namespace firsthit {

/// Phong's model. Colours are linear Rec.709 and may exceed 1.
///
/// source  Phong 1975, "Illumination for Computer Generated Pictures"
struct Phong {
    glm::vec3 ambient{0.1f};    // times Scene::ambient
    glm::vec3 diffuse{0.8f};    // share of light that is scattered
    glm::vec3 specular{0.0f};   // of highlights
    float shininess = 1.0f;     // Phong's exponent; below 0 counts as 0
    float transmittance = 0.0f; // 0 opaque to 1 clear; not drawn yet
    float ior = 1.0f;           // not drawn yet
    std::int32_t texture = -1;  // multiplies diffuse and ambient; -1 none
};

/// A surface that shows its colour, whatever lights and shadows are. Its albedo is that colour. No
/// file that is read today asks for it.
struct Unlit {
    glm::vec3 color{1.0f};     // linear Rec.709, may exceed 1
    std::int32_t texture = -1; // multiplies color; -1 none
};

/// What a surface's alpha does. There are only opaque surfaces yet.
enum class AlphaMode {
    opaque, // nothing: hits and shadows do not know it
};

/// A material: one of several shading models, and what all of them have.
struct Material {
    using Model = std::variant<Phong, Unlit>; // in the order of src/material/models.h

    std::string name;                    // as the file has it
    AlphaMode alpha = AlphaMode::opaque; // what its alpha does
    bool double_sided = true;            // nothing is culled: check_scene refuses false
    Model model;                         // how it reflects light
};

} // namespace firsthit
