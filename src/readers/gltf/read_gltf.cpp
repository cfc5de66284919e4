// read_gltf.cpp - glTF 2.0 files as scenes.
#include "readers/gltf/read_gltf.h"

#include "io/text_cursor.h"
#include "readers/gltf/scene_maker.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace firsthit {
namespace {

/// The scene that is asked for by number or name, else the file's own, else its first; kNone: all roots.
int chosen_scene(const gltf::Document& document, const std::string& chosen)
{
    const auto count = static_cast<int>(document.scenes.size());
    if (chosen.empty())
        return document.scene != gltf::kNone ? document.scene : count > 0 ? 0 : gltf::kNone;
    for (int s = 0; s < count; ++s)
        if (document.scenes[static_cast<std::size_t>(s)].name == chosen) return s;
    int number = -1;
    const char* end = chosen.data() + chosen.size();
    const auto [rest, error] = std::from_chars(chosen.data(), end, number);
    if (error == std::errc() && rest == end && number >= 0 && number < count) return number;
    std::string names;
    for (int s = 0; s < count; ++s)
        names += fmt::format("{}{} '{}'", s > 0 ? ", " : "", s,
            printable(document.scenes[static_cast<std::size_t>(s)].name));
    throw ArgumentError(fmt::format("{}: there is no scene '{}'; the file has {}", document.name,
        printable(chosen), names.empty() ? "none" : names));
}

Scene scene_of(const gltf::Document& document, const LoadSettings& settings)
{
    return gltf::SceneMaker(document, chosen_scene(document, settings.scene)).make();
}

} // namespace

Scene read_gltf(const std::filesystem::path& path, const LoadSettings& settings)
{
    return scene_of(gltf::read_document(path), settings);
}

Scene read_gltf(const std::string& name, std::string bytes, const std::filesystem::path& folder,
    const LoadSettings& settings)
{
    return scene_of(gltf::read_document(name, std::move(bytes), folder), settings);
}

} // namespace firsthit
