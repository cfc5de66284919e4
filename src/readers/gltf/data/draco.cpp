// draco.cpp - calls Draco's decoder, after a look at the sizes that the data promise.
#include "readers/gltf/data/draco.h"

#if FIRSTHIT_WITH_DRACO
#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>
#endif

#include <fmt/format.h>

#include <cstddef>
#include <exception>
#include <memory>

namespace firsthit::gltf {

#if FIRSTHIT_WITH_DRACO
namespace {

/// A number of the header: 32 bits in old streams.
bool decode_count(draco::DecoderBuffer& buffer, bool plain, std::uint32_t& value)
{
    return plain ? buffer.Decode(&value) : draco::DecodeVarint(&value, &buffer);
}

/// Reads faces and vertices from the start of the connectivity; false where it is cut off.
/// source  Draco's bitstream specification, sections 2 to 4
bool decode_counts(draco::DecoderBuffer& buffer, std::uint32_t& faces, std::uint32_t& vertices)
{
    draco::DracoHeader header;
    if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok()) return false;
    const auto version = static_cast<std::uint16_t>(
        DRACO_BITSTREAM_VERSION(header.version_major, header.version_minor));
    buffer.set_bitstream_version(version);
    if (header.encoder_type != draco::TRIANGULAR_MESH) return false;
    if (version >= DRACO_BITSTREAM_VERSION(1, 3) && (header.flags & METADATA_FLAG_MASK) != 0) {
        draco::GeometryMetadata metadata;
        draco::MetadataDecoder decoder;
        if (!decoder.DecodeGeometryMetadata(&buffer, &metadata)) return false;
    }
    const bool old = version < DRACO_BITSTREAM_VERSION(2, 2);
    if (header.encoder_method == draco::MESH_SEQUENTIAL_ENCODING)
        return decode_count(buffer, old, faces) && decode_count(buffer, old, vertices);
    const bool oldest = version < DRACO_BITSTREAM_VERSION(2, 0);
    std::uint8_t traversal = 0;
    std::uint32_t new_vertices = 0;
    return buffer.Decode(&traversal) && (!old || decode_count(buffer, oldest, new_vertices)) &&
           decode_count(buffer, oldest, vertices) && decode_count(buffer, oldest, faces);
}

template <class Number>
bool copy_attribute(
    const draco::PointAttribute& from, std::size_t points, int components, std::string& bytes)
{
    const auto size = static_cast<std::size_t>(components) * sizeof(Number);
    bytes.assign(points * size, '\0');
    Number element[4] = {};
    for (std::size_t point = 0; point < points; ++point) {
        const draco::AttributeValueIndex value =
            from.mapped_index(draco::PointIndex(static_cast<std::uint32_t>(point)));
        if (value.value() >= from.size() ||
            !from.ConvertValue<Number>(value, static_cast<std::int8_t>(components), element))
            return false;
        bytes.replace(point * size, size, reinterpret_cast<const char*>(element), size);
    }
    return true;
}

bool copy_any(const draco::PointAttribute& from, std::size_t points, const DracoRequest& request,
    std::string& bytes)
{
    switch (request.component) {
    case ComponentType::kByte:
        return copy_attribute<std::int8_t>(from, points, request.components, bytes);
    case ComponentType::kUnsignedByte:
        return copy_attribute<std::uint8_t>(from, points, request.components, bytes);
    case ComponentType::kShort:
        return copy_attribute<std::int16_t>(from, points, request.components, bytes);
    case ComponentType::kUnsignedShort:
        return copy_attribute<std::uint16_t>(from, points, request.components, bytes);
    case ComponentType::kUnsignedInt:
        return copy_attribute<std::uint32_t>(from, points, request.components, bytes);
    case ComponentType::kFloat:
        break;
    }
    return copy_attribute<float>(from, points, request.components, bytes);
}

std::string copy_mesh(
    const draco::Mesh& from, std::span<const DracoRequest> requests, DracoMesh& mesh)
{
    mesh.points = from.num_points();
    mesh.index.reserve(std::size_t(from.num_faces()) * 3);
    for (std::uint32_t face = 0; face < from.num_faces(); ++face)
        for (const draco::PointIndex& corner : from.face(draco::FaceIndex(face))) {
            if (corner.value() >= mesh.points) return "the compressed data are damaged";
            mesh.index.push_back(corner.value());
        }
    for (const DracoRequest& request : requests) {
        const draco::PointAttribute* const attribute = from.GetAttributeByUniqueId(request.id);
        if (!attribute)
            return fmt::format("attribute {} is not in the compressed data", request.id);
        if (attribute->num_components() != request.components)
            return fmt::format("attribute {} has {} components, its accessor {}", request.id,
                int(attribute->num_components()), request.components);
        if (!copy_any(*attribute, mesh.points, request, mesh.attribute.emplace_back()))
            return fmt::format(
                "attribute {} does not fit its accessor's componentType", request.id);
    }
    return {};
}

} // namespace

bool can_decode_draco()
{
    return true;
}

std::string check_draco_sizes(std::span<const char> packed)
{
    // Real data take more than a bit a triangle; Draco takes some hundred bytes for each.
    constexpr std::uint64_t kFacesOfByte = 64, kFewFaces = 1 << 16;
    draco::DecoderBuffer buffer;
    buffer.Init(packed.data(), packed.size());
    std::uint32_t faces = 0, vertices = 0;
    if (!decode_counts(buffer, faces, vertices)) return "the compressed data are no triangle mesh";
    const std::uint64_t most = kFewFaces + kFacesOfByte * packed.size();
    if (faces > most || vertices > 3 * most)
        return fmt::format(
            "the data promise {} triangles and {} vertices, {} bytes cannot hold them", faces,
            vertices, packed.size());
    return {};
}

std::string decode_draco(
    std::span<const char> packed, std::span<const DracoRequest> requests, DracoMesh& mesh)
{
    try {
        if (std::string wrong = check_draco_sizes(packed); !wrong.empty()) return wrong;
        draco::DecoderBuffer buffer;
        buffer.Init(packed.data(), packed.size());
        draco::Decoder decoder;
        draco::StatusOr<std::unique_ptr<draco::Mesh>> decoded =
            decoder.DecodeMeshFromBuffer(&buffer);
        if (!decoded.ok()) {
            const std::string& reason = decoded.status().error_msg_string();
            return "the compressed data are damaged" + (reason.empty() ? "" : " (" + reason + ")");
        }
        return copy_mesh(*decoded.value(), requests, mesh);
    } catch (const std::exception& error) {
        return fmt::format("the compressed data cannot be unpacked ({})", error.what());
    }
}

#else

bool can_decode_draco()
{
    return false;
}

std::string check_draco_sizes(std::span<const char>)
{
    return kNoDraco;
}

std::string decode_draco(std::span<const char>, std::span<const DracoRequest>, DracoMesh&)
{
    return kNoDraco;
}

#endif

} // namespace firsthit::gltf
