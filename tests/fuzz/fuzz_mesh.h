// fuzz_mesh.h - what every mesh reader is held to: a sound scene or an error of ours.
#pragma once

#include "scene/model/check_scene.h"
#include "readers/mesh_file.h"

#include <firsthit/error.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace firsthit {

inline int fuzz_mesh(const std::uint8_t* data, std::size_t size, const char* extension)
{
    LoadSettings settings;
    // The first byte chooses between smooth normals and creases.
    if (size > 0 && data[0] % 2 == 1) settings.crease_angle_rad = 0.5;
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    try {
        check_scene(read_mesh(bytes, extension, "fuzz", {}, settings));
    } catch (const Error&) {
        // Refused with a reason: what damaged files should meet.
    }
    return 0;
}

} // namespace firsthit
