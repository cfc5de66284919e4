// read_textures.cpp - the samplers, images and textures of a glTF document; pixels are read later.
#include "readers/gltf/document/loader.h"
#include "readers/gltf/data/uri.h"
#include "readers/image/webp.h"

#include <fmt/format.h>

#include <array>
#include <initializer_list>
#include <utility>

namespace firsthit::gltf {
namespace {

/// The member as one of the codes; the fallback, with a warning, where it is another number.
template <class Code>
Code code(Loader& loader, const Place& place, const char* key, Code fallback,
    std::initializer_list<Code> accepted)
{
    const std::size_t value = place.size(key, static_cast<std::size_t>(fallback));
    for (const Code known : accepted)
        if (static_cast<std::size_t>(known) == value) return known;
    if (place.has(key))
        loader.warn(std::string("code ") + key,
            fmt::format(
                "{}.{} is {}, which is unknown; the default is used", place.path(), key, value));
    return fallback;
}

Sampler read_texture_sampler(Loader& loader, const Place& place)
{
    const auto wrap = [&](const char* key) {
        return code(loader, place, key, Wrap::kRepeat,
            {Wrap::kRepeat, Wrap::kClampToEdge, Wrap::kMirroredRepeat});
    };
    return {.wrap_s = wrap("wrapS"),
        .wrap_t = wrap("wrapT"),
        .mag_filter =
            code(loader, place, "magFilter", Filter::kUnset, {Filter::kNearest, Filter::kLinear}),
        .min_filter = code(loader, place, "minFilter", Filter::kUnset,
            {Filter::kNearest, Filter::kLinear, Filter::kNearestMipmapNearest,
                Filter::kLinearMipmapNearest, Filter::kNearestMipmapLinear,
                Filter::kLinearMipmapLinear})};
}

Image read_image_entry(Loader& loader, const Place& place)
{
    Document& document = loader.document;
    Image image;
    image.name = place.text("name");
    image.mime_type = place.text("mimeType");
    image.buffer_view = place.index("bufferView", document.buffer_views.size());
    const std::string uri = place.text("uri");
    if (image.buffer_view != kNone) {
        if (!uri.empty())
            loader.warn("image twice",
                fmt::format("{} has a uri and a bufferView; the uri is not read", place.path()));
        if (document.buffer_views[std::size_t(image.buffer_view)].byte_stride != 0)
            loader.warn("image stride",
                fmt::format(
                    "{} is in a buffer view with a byteStride, which is ignored", place.path()));
        if (image.mime_type.empty())
            loader.warn(
                "image type", fmt::format("{} has a bufferView and no mimeType", place.path()));
    } else if (is_data_uri(uri)) {
        std::string said;
        std::optional<std::string> bytes = decode_data_uri(uri, said);
        if (bytes)
            image.data = std::make_shared<const std::string>(std::move(*bytes));
        else
            image.missing = "its data URI is damaged";
        if (image.mime_type.empty()) image.mime_type = said;
    } else if (uri.empty()) {
        image.missing = "it has neither a uri nor a bufferView";
        loader.warn(
            "image empty", fmt::format("{} has neither a uri nor a bufferView", place.path()));
    } else if (has_scheme(uri)) {
        image.uri = uri;
        image.missing = "only data URIs and names of files are read";
    } else {
        image.uri = percent_decoded(uri);
        if (document.folder.empty())
            image.missing = "other files are not read without a folder";
        else
            document.files.push_back(image.path = resolve_uri(document.folder, uri).string());
    }
    return image;
}

} // namespace

void read_textures(Loader& loader)
{
    Document& document = loader.document;
    std::vector<Sampler> samplers;
    loader.root.each("samplers", [&](std::size_t, const Place& place) {
        samplers.push_back(read_texture_sampler(loader, place));
    });
    loader.root.each("images", [&](std::size_t, const Place& place) {
        document.images.push_back(read_image_entry(loader, place));
    });
    loader.root.each("textures", [&](std::size_t, const Place& place) {
        Texture texture;
        texture.name = place.text("name");
        if (const int sampler = place.index("sampler", samplers.size()); sampler != kNone)
            texture.sampler = samplers[std::size_t(sampler)];
        const std::size_t images = document.images.size();
        texture.image = place.index("source", images);
        // Formats that cannot be decoded are named where there is nothing else.
        int webp = kNone, other = kNone;
        if (const auto e = place.extension("EXT_texture_webp")) webp = e->index("source", images);
        for (const char* name : {"KHR_texture_basisu", "EXT_texture_avif", "MSFT_texture_dds"})
            if (const auto e = place.extension(name)) other = e->index("source", images);
        if (webp != kNone && (can_decode_webp() || texture.image == kNone)) texture.image = webp;
        if (texture.image == kNone) texture.image = other;
        if (texture.image == kNone)
            loader.warn("texture without image",
                fmt::format("{} has no image that is supported; it is not shown", place.path()));
        document.textures.push_back(std::move(texture));
    });
}

} // namespace firsthit::gltf
