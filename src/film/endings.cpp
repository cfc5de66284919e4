// endings.cpp - which formats the endings of files stand for, and whether a film has what is to be written.
#include "film/endings.h"

#include "io/output_file.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace firsthit {

std::string ending_of(const std::string& path, const char* of_device)
{
    std::string ending = std::filesystem::path(path).extension().string();
    if (ending.empty() && is_device(path)) return of_device;
    std::transform(ending.begin(), ending.end(), ending.begin(),
        [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return ending;
}

std::string plane_ending(Aov aov, const std::string& path, const std::string& format)
{
    std::string ending = format.empty() ? ending_of(path, ".npy") : format;
    if (ending == ".exr" || ending == ".npy") return ending;
    if (ending == ".png" && (aov == Aov::depth || aov == Aov::distance)) return ending;
    if (ending == ".png")
        throw ArgumentError(
            fmt::format("{}: the plane '{}' is not written as .png, which is for depth "
                        "and distance in millimetres: accepted are .exr and .npy",
                path, aov_name(aov)));
    throw ArgumentError(fmt::format("{}: unknown ending '{}' for a plane: accepted are .exr and "
                                    ".npy, and .png for depth and distance",
        path, ending));
}

void check_shape(const Film& film, const PlaneView& plane, std::string_view name)
{
    const std::size_t pixels =
        film.width > 0 && film.height > 0
            ? static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height)
            : 0;
    const std::size_t values = plane.item.size() + plane.value.size();
    if (values == 0) throw ArgumentError(fmt::format("the film has no plane '{}'", name));
    if (values != pixels * static_cast<std::size_t>(plane.channels))
        throw ArgumentError(fmt::format("the film's plane '{}' has {} values, not {} x {} x {}",
            name, values, film.height, film.width, plane.channels));
}

} // namespace firsthit
