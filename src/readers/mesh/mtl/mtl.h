// mtl.h - the material libraries of OBJ files.
#pragma once

#include "readers/mesh/mtl/mtl_map.h"
#include "readers/problems.h"

#include <firsthit/material.h>

#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace firsthit {

/// A material as its library has it. Colours are linear.
struct MtlMaterial {
    std::string name;
    Phong phong;                    // Ka (that of Kd where there is none), Kd, Ks, Ns, Ni
    float opacity = 1;              // d; where there is none 1 - Tr, but 1 for Tr 1
    glm::vec3 emission{0};          // Ke
    MtlMap diffuse_map;             // map_Kd
    MtlMap opacity_map;             // map_d
    MtlMap emission_map;            // map_Ke
    std::optional<float> roughness; // Pr
    std::optional<float> metallic;  // Pm
    MtlMap roughness_map;           // map_Pr
    MtlMap metallic_map;            // map_Pm
    MtlMap normal_map;              // norm

    /// Whether only the model of metals and rough surfaces has all that it asks for.
    bool is_physical() const
    {
        const bool glows = emission != glm::vec3(0);
        return roughness || metallic || roughness_map || metallic_map || normal_map ||
               emission_map || (glows && diffuse_map);
    }
};

/// Reads a library. Statements that are not listed above are left out; words are known in upper and
/// lower case. What is no finite number, and what stands before the first material, is left out
/// with a problem; the value keeps its default.
///
/// name    of the library, for messages
/// throws  FileError: UTF-16, more than 262,144 materials
std::vector<MtlMaterial> read_mtl(
    std::string_view text, const std::string& name, Problems& problems);

} // namespace firsthit
