// document.cpp - reads a glTF document part by part.
#include "readers/gltf/document/document.h"

#include "readers/gltf/data/glb.h"
#include "readers/gltf/document/loader.h"
#include "io/text_cursor.h"
#include "io/whole_file.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace firsthit::gltf {
namespace {

constexpr std::uint64_t kFreeBytes = std::uint64_t(256) << 20; // that any document may unpack to
constexpr std::uint64_t kMaxRatio = 64; // and more for each byte that is read

void read_asset(Loader& loader)
{
    // glTF 1.0 has objects where 2.0 has arrays, and often no asset.
    const std::optional<Place> asset = loader.root.find("asset");
    const Json& json = loader.root.json();
    const auto meshes = json.find("meshes");
    const bool is_old = meshes != json.end() && meshes->is_object();
    if (!asset && !is_old) loader.root.fail("asset", "is missing; accepted are files of glTF 2.0");
    Asset& told = loader.document.asset;
    // Files of glTF 1.0 have the version as a number, too.
    if (asset && asset->json().contains("version") && asset->json()["version"].is_number())
        told.version = asset->json()["version"].dump();
    else if (asset)
        told.version = asset->text("version");
    if (is_old && told.version.empty()) told.version = "1.0";
    if (!told.version.starts_with("2."))
        loader.root.fail("asset.version",
            told.version.empty()
                ? "is missing; accepted is 2.0"
                : fmt::format("glTF {} is not accepted; accepted is 2.0", printable(told.version)));
    if (const std::string least = asset->text("minVersion"); !least.empty() && least != "2.0")
        loader.root.fail("asset.minVersion",
            fmt::format("glTF {} is not accepted; accepted is 2.0", printable(least)));
    told.generator = asset->text("generator");
    told.copyright = asset->text("copyright");
}

Document read(Document document, std::string bytes)
{
    const auto storage = std::make_shared<const std::string>(std::move(bytes));
    const std::string name = document.name;
    std::string_view text = *storage;
    const bool binary = is_glb(text);
    Container container;
    if (binary) {
        container = split_glb(text, name);
        text = container.json;
        // The specification asks for spaces.
        const std::size_t padding =
            text.size() - std::min(text.size(), text.find_last_not_of('\0') + 1);
        if (padding != 0) container.warnings.emplace_back("the JSON chunk is padded with zeros");
        text.remove_suffix(padding);
    }
    if (text.starts_with("\xEF\xBB\xBF")) {
        text.remove_prefix(3);
        container.warnings.emplace_back("the JSON text begins with a byte order mark");
    }
    const Json json = parse_json(text, name);
    if (!json.is_object())
        throw FileError(fmt::format("{}: not a glTF file: the JSON text is no object", name));

    Loader loader(document, Place(name, json));
    loader.is_glb = binary;
    loader.bytes_read = storage->size();
    if (container.has_binary) {
        loader.binary.storage = storage;
        loader.binary.bytes = container.binary;
    }
    for (const std::string& warning : container.warnings) loader.warn(warning);
    read_asset(loader);
    read_extensions(loader);
    read_buffers(loader);
    read_buffer_views(loader);
    read_accessors(loader);
    read_textures(loader);
    read_materials(loader);
    read_meshes(loader);
    read_cameras(loader);
    read_lights(loader);
    read_nodes(loader);
    read_skins(loader);
    read_scenes(loader);
    read_animations(loader);
    return document;
}

} // namespace

void Loader::warn(std::string_view topic, std::string_view message)
{
    if (warned.emplace(topic).second)
        document.warnings.push_back(fmt::format("{}: {}", document.name, shown(message)));
}

void Loader::take(const Place& place, std::uint64_t bytes)
{
    bytes_unpacked += bytes;
    const std::uint64_t most = kFreeBytes + kMaxRatio * bytes_read;
    if (bytes_unpacked > most)
        place.fail(
            "", fmt::format("more than {} MiB of accessors, which {} bytes of files may unpack to",
                    most >> 20, bytes_read));
}

Document read_document(const std::filesystem::path& path)
{
    Document document;
    document.name = path.string();
    document.folder = path.has_parent_path() ? path.parent_path() : ".";
    document.files.push_back(path.string());
    return read(std::move(document), read_whole_file(path));
}

Document read_document(
    const std::string& name, std::string bytes, const std::filesystem::path& folder)
{
    Document document;
    document.name = name;
    document.folder = folder;
    return read(std::move(document), std::move(bytes));
}

} // namespace firsthit::gltf
