// read_draco.h - puts unpacked accessors in the place of a primitive's compressed ones.
#pragma once

#include "readers/gltf/document/loader.h"

namespace firsthit::gltf {

/// Where the primitive has KHR_draco_mesh_compression: its attributes and indices then name accessors
/// with the unpacked data. Where they cannot be unpacked and there are uncompressed ones, those stay,
/// with a warning.
/// throws  FileError: damaged, or the library is missing, and there are no others
void unpack_draco(Loader& loader, const Place& place, Primitive& primitive);

} // namespace firsthit::gltf
