// check_attributes.h - whether the accessors of a primitive are of the types that glTF allows.
#pragma once

#include "readers/gltf/document/loader.h"

#include <initializer_list>
#include <string_view>

namespace firsthit::gltf {

/// What readers of a primitive rely on (document.h) is an error where it does not hold; other
/// deviations are a warning.
/// throws  FileError that names the attribute, its type, and what is accepted
void check_primitive(Loader& loader, const Place& place, const Primitive& primitive);

/// The accessor's type is among `types`.
/// key  of the accessor in `place`, for the message
void check_type(const Loader& loader, const Place& place, std::string_view key, int accessor,
    std::initializer_list<ElementType> types);

} // namespace firsthit::gltf
