// glb.h - the binary container of glTF: a JSON text and a buffer.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace firsthit::gltf {

struct Container {
    std::string_view json;
    std::span<const char> binary; // the BIN chunk
    bool has_binary = false;
    std::vector<std::string> warnings; // without the file's name
};

/// Whether these bytes start with the magic number 'glTF'.
bool is_glb(std::string_view bytes);

/// Views of `bytes`. Bytes after the end, unknown chunks, odd padding and a wrong total length are
/// tolerated with a warning.
/// throws  FileError: another version (names it), cut off, without a JSON chunk
Container split_glb(std::string_view bytes, const std::string& name);

} // namespace firsthit::gltf
