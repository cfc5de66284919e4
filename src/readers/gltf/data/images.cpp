// images.cpp - finds and decodes the pictures of a glTF document.
#include "readers/gltf/data/images.h"

#include "readers/image/image_file.h"
#include "readers/image/webp.h"
#include "io/whole_file.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <string_view>

namespace firsthit::gltf {
namespace {

ImageKind kind_of(std::span<const char> bytes)
{
    const std::string_view text(bytes.data(), bytes.size());
    if (text.starts_with("\x89PNG\r\n\x1a\n")) return ImageKind::kPng;
    if (text.starts_with("\xFF\xD8\xFF")) return ImageKind::kJpeg;
    if (is_webp(bytes)) return ImageKind::kWebP;
    if (text.starts_with("\xABKTX 20\xBB\r\n\x1A\n")) return ImageKind::kKtx2;
    if (text.starts_with("sB")) return ImageKind::kBasis;
    return ImageKind::kUnknown;
}

} // namespace

std::string image_name(const Document& document, int image)
{
    const Image& entry = document.images[std::size_t(image)];
    if (!entry.path.empty()) return entry.path;
    if (entry.name.empty()) return fmt::format("{}: image {}", document.name, image);
    return fmt::format("{}: image {} '{}'", document.name, image, entry.name);
}

ImageBytes read_image(const Document& document, int image)
{
    const Image& entry = document.images[std::size_t(image)];
    ImageBytes found;
    if (!entry.missing.empty()) {
        const std::string uri = entry.uri.empty() ? "" : fmt::format("'{}': ", entry.uri);
        throw FileError(fmt::format("{}: {}{}", image_name(document, image), uri, entry.missing));
    }
    if (entry.buffer_view != kNone) {
        const BufferView& view = document.buffer_views[std::size_t(entry.buffer_view)];
        if (!view.storage)
            throw FileError(fmt::format(
                "{}: its bytes are missing: {}", image_name(document, image), view.missing));
        found.storage = view.storage;
        found.bytes = view.bytes;
    } else {
        found.storage = entry.data
                            ? entry.data
                            : std::make_shared<const std::string>(read_whole_file(entry.path));
        found.bytes = *found.storage;
    }
    found.kind = kind_of(found.bytes);
    return found;
}

DecodedImage decode_image(const Document& document, int image)
{
    try {
        const ImageBytes found = read_image(document, image);
        switch (found.kind) {
        case ImageKind::kPng:
        case ImageKind::kJpeg:
        case ImageKind::kWebP:
            return {
                .picture = decode_picture(image_name(document, image), found.bytes), .why_not = {}};
        case ImageKind::kKtx2:
            return {.picture = {},
                .why_not = image_name(document, image) + ": pictures in KTX2 are not supported"};
        case ImageKind::kBasis:
            return {.picture = {},
                .why_not = image_name(document, image) +
                           ": pictures in Basis Universal are not supported"};
        case ImageKind::kUnknown:
            break;
        }
        return {.picture = {},
            .why_not = image_name(document, image) + ": not a PNG, JPEG or WebP picture"};
    } catch (const FileError& error) {
        return {.picture = {}, .why_not = error.what()};
    }
}

} // namespace firsthit::gltf
