// images.h - the pictures of a glTF document.
#pragma once

#include "readers/gltf/document/document.h"

#include <firsthit/texture.h>

#include <memory>
#include <optional>
#include <span>
#include <string>

namespace firsthit::gltf {

/// By content, whatever the document says.
enum class ImageKind { kUnknown, kPng, kJpeg, kWebP, kKtx2, kBasis };

struct ImageBytes {
    std::shared_ptr<const std::string> storage; // keeps the bytes
    std::span<const char> bytes;
    ImageKind kind = ImageKind::kUnknown;
};

/// throws  FileError: the file is missing or cannot be read, the buffer has no bytes
ImageBytes read_image(const Document& document, int image);

struct DecodedImage {
    std::optional<Picture> picture;
    std::string why_not; // where there is no picture; for a warning, it names file and image
};

/// Never throws for what a file contains.
DecodedImage decode_image(const Document& document, int image);

/// As messages have it: its file's name, else "image 3 'wood'".
std::string image_name(const Document& document, int image);

} // namespace firsthit::gltf
