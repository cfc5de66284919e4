// meshopt.cpp - calls meshoptimizer's decoders with what they may be called with.
#include "readers/gltf/data/meshopt.h"

#include <fmt/format.h>

#if FIRSTHIT_WITH_MESHOPT
#include <meshoptimizer.h>
#endif

namespace firsthit::gltf {

bool can_unpack_meshopt()
{
#if FIRSTHIT_WITH_MESHOPT
    return true;
#else
    return false;
#endif
}

std::string check_meshopt(const MeshoptLayout& layout, std::size_t packed)
{
    // The vertex codec needs 2 bits for 16 bytes, the index codecs a byte for a triangle or an index.
    constexpr std::size_t kMostVertexRatio = 64;
    const auto& [stride, count, mode, filter] = layout;
    const bool filtered = !filter.empty() && filter != "NONE";
    std::size_t most = 0; // elements
    if (mode == "ATTRIBUTES") {
        if (stride == 0 || stride > 256 || stride % 4 != 0)
            return fmt::format(
                "byteStride {} is not accepted; accepted are multiples of 4 up to 256", stride);
        most = packed * kMostVertexRatio / stride;
    } else if (mode == "TRIANGLES" || mode == "INDICES") {
        if (stride != 2 && stride != 4)
            return fmt::format("byteStride {} is not accepted; accepted are 2 and 4", stride);
        if (filtered) return fmt::format("the filter '{}' is not accepted for indices", filter);
        if (mode == "TRIANGLES" && count % 3 != 0)
            return fmt::format("count {} is no multiple of 3", count);
        most = mode == "TRIANGLES" ? packed * 3 : packed;
    } else {
        return fmt::format(
            "the mode '{}' is not accepted; accepted are ATTRIBUTES, TRIANGLES, INDICES", mode);
    }
    if (count > most)
        return fmt::format("count {} is more than {} compressed bytes can hold", count, packed);
    if (!filtered) return {};
    if (filter == "OCTAHEDRAL" && stride != 4 && stride != 8)
        return fmt::format(
            "byteStride {} is not accepted for OCTAHEDRAL; accepted are 4 and 8", stride);
    if (filter == "QUATERNION" && stride != 8)
        return fmt::format("byteStride {} is not accepted for QUATERNION; accepted is 8", stride);
    if (filter != "OCTAHEDRAL" && filter != "QUATERNION" && filter != "EXPONENTIAL")
        return fmt::format("the filter '{}' is not accepted; accepted are NONE, OCTAHEDRAL, "
                           "QUATERNION, EXPONENTIAL",
            filter);
    return {};
}

bool unpack_meshopt([[maybe_unused]] const MeshoptLayout& layout,
    [[maybe_unused]] std::span<const char> packed, [[maybe_unused]] char* unpacked)
{
#if FIRSTHIT_WITH_MESHOPT
    const auto* bytes = reinterpret_cast<const unsigned char*>(packed.data());
    const auto& [stride, count, mode, filter] = layout;
    if (count == 0) return true;
    const int failed =
        mode == "ATTRIBUTES"
            ? meshopt_decodeVertexBuffer(unpacked, count, stride, bytes, packed.size())
        : mode == "TRIANGLES"
            ? meshopt_decodeIndexBuffer(unpacked, count, stride, bytes, packed.size())
            : meshopt_decodeIndexSequence(unpacked, count, stride, bytes, packed.size());
    if (failed != 0) return false;
    if (filter == "OCTAHEDRAL") meshopt_decodeFilterOct(unpacked, count, stride);
    if (filter == "QUATERNION") meshopt_decodeFilterQuat(unpacked, count, stride);
    if (filter == "EXPONENTIAL") meshopt_decodeFilterExp(unpacked, count, stride);
    return true;
#else
    return false;
#endif
}

} // namespace firsthit::gltf
