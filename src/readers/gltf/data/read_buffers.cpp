// read_buffers.cpp - the bytes of a glTF document: buffers from files and data URIs, and views of them.
#include "readers/gltf/document/loader.h"
#include "readers/gltf/data/meshopt.h"
#include "readers/gltf/data/uri.h"
#include "io/whole_file.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

namespace firsthit::gltf {
namespace {

Buffer whole(std::string bytes)
{
    Buffer buffer;
    buffer.storage = std::make_shared<const std::string>(std::move(bytes));
    buffer.bytes = *buffer.storage;
    return buffer;
}

/// Files that buffers were read from: one that is named many times is in memory once.
using KnownFiles = std::map<std::string, Buffer>;

Buffer read_buffer(Loader& loader, KnownFiles& known, const Place& place, std::size_t number)
{
    Document& document = loader.document;
    if (!place.has("uri")) {
        if (loader.is_glb && number == 0 && loader.binary.storage) return loader.binary;
        Buffer buffer;
        buffer.missing = kNoUri;
        return buffer;
    }
    const std::string uri = place.text("uri");
    if (is_data_uri(uri)) {
        std::string mime_type;
        std::optional<std::string> bytes = decode_data_uri(uri, mime_type);
        if (!bytes) place.fail("uri", "the data URI is damaged");
        return whole(std::move(*bytes));
    }
    if (uri.empty()) place.fail("uri", "is empty");
    if (has_scheme(uri))
        place.fail("uri", fmt::format("'{}' is not accepted; accepted are data URIs and names of "
                                      "files beside the document",
                              uri));
    if (document.folder.empty()) {
        Buffer buffer;
        buffer.missing = fmt::format("the file '{}' is not read without a folder", uri);
        return buffer;
    }
    const std::filesystem::path path = resolve_uri(document.folder, uri);
    if (const auto found = known.find(path.string()); found != known.end()) return found->second;
    document.files.push_back(path.string());
    try {
        Buffer buffer = whole(read_whole_file(path));
        loader.bytes_read += buffer.bytes.size();
        return known[path.string()] = buffer;
    } catch (const FileError& error) {
        place.fail("uri", error.what());
    }
}

/// A part of a buffer, whatever of it is there.
/// place  an object with buffer, byteOffset and byteLength
BufferView slice(const Loader& loader, const Place& place)
{
    const Document& document = loader.document;
    const Buffer& buffer =
        document.buffers[std::size_t(place.required_index("buffer", document.buffers.size()))];
    const std::size_t offset = place.size("byteOffset", 0);
    BufferView view;
    view.byte_length = place.size("byteLength");
    // Both are below 2^53.
    if (offset + view.byte_length > buffer.byte_length)
        place.fail("", fmt::format("bytes {} to {} are beyond the buffer's {}", offset,
                           offset + view.byte_length, buffer.byte_length));
    if (!buffer.storage) {
        view.missing = buffer.missing;
    } else if (offset + view.byte_length > buffer.bytes.size()) {
        view.missing = fmt::format(
            "its buffer ends after {} of {} bytes", buffer.bytes.size(), buffer.byte_length);
    } else {
        view.storage = buffer.storage;
        view.bytes = buffer.bytes.subspan(offset, view.byte_length);
    }
    return view;
}

/// Unpacks EXT_meshopt_compression into the view.
void unpack(Loader& loader, const Place& packed_place, BufferView& view)
{
    const BufferView packed = slice(loader, packed_place);
    const MeshoptLayout layout = {.stride = packed_place.size("byteStride"),
        .count = packed_place.size("count"),
        .mode = packed_place.text("mode"),
        .filter = packed_place.text("filter")};
    if (!packed.storage) {
        view.missing = packed.missing;
        return;
    }
    if (!can_unpack_meshopt()) {
        loader.warn("meshopt", kNoMeshopt);
        if (!view.storage) view.missing = kNoMeshopt;
        return;
    }
    if (const std::string wrong = check_meshopt(layout, packed.bytes.size()); !wrong.empty())
        packed_place.fail("", wrong);
    const std::size_t bytes = layout.count * layout.stride;
    if (bytes < view.byte_length)
        packed_place.fail("",
            fmt::format("unpacks to {} bytes, the buffer view has {}", bytes, view.byte_length));
    loader.take(packed_place, bytes);
    std::string unpacked(bytes, '\0');
    if (!unpack_meshopt(layout, packed.bytes, unpacked.data()))
        packed_place.fail("", "the compressed data are damaged");
    view.storage = std::make_shared<const std::string>(std::move(unpacked));
    view.bytes = std::span<const char>(*view.storage).first(view.byte_length);
    view.missing.clear();
}

} // namespace

void read_buffers(Loader& loader)
{
    KnownFiles known;
    loader.root.each("buffers", [&](std::size_t number, const Place& place) {
        Buffer buffer = read_buffer(loader, known, place, number);
        buffer.byte_length = place.size("byteLength");
        if (buffer.byte_length == 0) loader.warn("empty buffer", "a buffer has no bytes");
        if (buffer.storage && buffer.bytes.size() < buffer.byte_length)
            loader.warn("short buffer", fmt::format("{} has {} bytes instead of {}", place.path(),
                                            buffer.bytes.size(), buffer.byte_length));
        // A chunk is padded to a multiple of four.
        if (buffer.storage && buffer.storage == loader.binary.storage &&
            buffer.bytes.size() > buffer.byte_length &&
            buffer.bytes.size() - buffer.byte_length > 3)
            loader.warn("long buffer", fmt::format("the BIN chunk has {} bytes, {} are used",
                                           buffer.bytes.size(), buffer.byte_length));
        buffer.bytes = buffer.bytes.first(std::min(buffer.bytes.size(), buffer.byte_length));
        loader.document.buffers.push_back(std::move(buffer));
    });
    if (loader.binary.storage && (loader.document.buffers.empty() ||
                                     loader.document.buffers[0].storage != loader.binary.storage))
        loader.warn("the BIN chunk is not used");
}

void read_buffer_views(Loader& loader)
{
    loader.root.each("bufferViews", [&](std::size_t, const Place& place) {
        BufferView view = slice(loader, place);
        view.name = place.text("name");
        view.byte_stride = place.size("byteStride", 0, 1 << 20);
        if (place.has("byteStride") &&
            (view.byte_stride < 4 || view.byte_stride > 252 || view.byte_stride % 4 != 0))
            loader.warn("stride", fmt::format("{}.byteStride is {}; a multiple of 4 from 4 to 252 "
                                              "was expected",
                                      place.path(), view.byte_stride));
        for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
            if (const std::optional<Place> packed = place.extension(name))
                unpack(loader, *packed, view);
        loader.document.buffer_views.push_back(std::move(view));
    });
}

} // namespace firsthit::gltf
