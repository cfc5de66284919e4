// mask_objects.h - what gets a mask: instances, nodes or materials, with names and categories.
#pragma once

#include <firsthit/film.h>
#include <firsthit/scene.h>

#include <cstdint>
#include <string>
#include <vector>

namespace firsthit::cli {

/// "instance", "node" or "material". throws  UsageError
Aov parse_mask_kind(const std::string& text);

/// The objects of a scene. By number: that of the plane of their kind.
struct MaskObjects {
    std::vector<std::vector<std::uint32_t>> instances; // of each object, ascending
    std::vector<std::string> name;                     // of each object, as the file has it
    std::vector<std::string> category;                 // of each object
};

/// The category of an instance is its mesh's name, or its own where that has none; that of a node is its
/// first instance's; that of a material its own name. What has no name is an "object".
/// kind  Aov::instance, node or material
MaskObjects mask_objects(const Scene& scene, Aov kind);

} // namespace firsthit::cli
