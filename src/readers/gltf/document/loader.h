// loader.h - what the parts of the glTF reader share while they fill a document in.
#pragma once

#include "readers/gltf/document/document.h"
#include "readers/gltf/document/place.h"

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <string_view>

namespace firsthit::gltf {

struct Loader {
    Loader(Document& filled, const Place& top) : document(filled), root(top) {}

    Document& document;
    Place root;
    Buffer binary; // the BIN chunk of a GLB file
    bool is_glb = false;
    std::uint64_t bytes_read = 0;     // of all files
    std::uint64_t bytes_unpacked = 0; // that accessors and compressed views need
    std::set<std::string, std::less<>> warned;

    /// Adds a warning; of each topic only the first.
    void warn(std::string_view topic, std::string_view message);
    void warn(std::string_view message) { warn(message, message); }

    /// Counts bytes that are about to be taken.
    /// throws  FileError at `place` beyond the limit (document.h)
    void take(const Place& place, std::uint64_t bytes);
};

// In this order; each fills in one part of the document and needs those before it.
void read_extensions(Loader& loader);
void read_buffers(Loader& loader);
void read_buffer_views(Loader& loader);
void read_accessors(Loader& loader);
void read_textures(Loader& loader);
void read_materials(Loader& loader);
void read_meshes(Loader& loader);
void read_cameras(Loader& loader);
void read_lights(Loader& loader);
void read_nodes(Loader& loader);
void read_skins(Loader& loader);
void read_scenes(Loader& loader);
void read_animations(Loader& loader);

} // namespace firsthit::gltf
