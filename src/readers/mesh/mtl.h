// mtl.h - the material libraries of OBJ files.
#pragma once

#include <firsthit/scene.h>

#include <string>
#include <string_view>
#include <vector>

namespace firsthit {

/// A material as its library has it; the texture is still a file's name.
struct MtlMaterial {
    std::string name;
    Phong material;
    bool has_ambient = false;
    std::string texture; // map_Kd, relative to the library's folder; empty: none
};

/// Reads newmtl, Ka, Kd, Ks, Ns, Ni, d, Tr and map_Kd; other statements are left out. Numbers are
/// taken as they are: colours linear, Ns as Phong's exponent. A material without Ka has that of Kd.
///
/// name    of the library, for messages
/// throws  FileError, SceneError with the line: a number that is none or not finite, a value before
///         the first newmtl
std::vector<MtlMaterial> read_mtl(std::string_view text, const std::string& name);

} // namespace firsthit
