// environment_file.h - reads pictures of what is all around.
#pragma once

#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace firsthit {

/// (height, width) linear light, top row first.
struct RadiancePicture {
    int width = 0, height = 0;
    std::vector<glm::vec3> radiance;
};

/// The bytes of a Radiance picture (.hdr), by stb_image.
/// throws  FileError: another format, damaged, larger than an EnvironmentMap may be
RadiancePicture decode_radiance(const std::string& name, const std::string& bytes);

/// The bytes of an OpenEXR picture with channels R, G and B.
/// throws  FileError: as decode_radiance; a channel is missing
RadiancePicture decode_exr(const std::string& name, const std::string& bytes);

} // namespace firsthit
