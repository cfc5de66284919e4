// fuzz_gltf.cpp - glTF and GLB files of any bytes: they are read with all that is in them, or refused
// by an error of ours.
#include "readers/gltf/document/document.h"
#include "readers/gltf/data/images.h"
#include "readers/gltf/read_gltf.h"

#include <firsthit/error.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

namespace {

using namespace firsthit;
using namespace firsthit::gltf;

/// Runs an action that may meet what is missing or no number.
template <class Action>
void attempt(const Action& action)
{
    try {
        action();
    } catch (const Error&) {
    }
}

void read_all(const Document& document)
{
    for (std::size_t k = 0; k < document.accessors.size(); ++k) {
        const int accessor = static_cast<int>(k);
        const Accessor& entry = document.accessors[k];
        attempt([&] {
            const std::size_t numbers = entry.count * std::size_t(entry.components());
            if (read_floats(document, accessor, entry.components()).size() != numbers) std::abort();
        });
        attempt([&] { read_uints(document, accessor, entry.components()); });
        attempt([&] { read_matrices(document, accessor); });
    }
    for (const gltf::Mesh& mesh : document.meshes)
        for (const Primitive& primitive : mesh.primitives) {
            if (primitive.attributes.empty()) continue;
            const int first = primitive.attributes.begin()->second;
            const std::size_t vertices = document.accessors[std::size_t(first)].count;
            attempt([&] {
                for (const std::uint32_t index : read_indices(document, primitive, vertices))
                    if (index >= vertices) std::abort();
            });
        }
    for (std::size_t k = 0; k < document.images.size(); ++k)
        if (decode_image(document, static_cast<int>(k)).why_not.empty() ==
            !decode_image(document, static_cast<int>(k)).picture)
            std::abort();
}

/// Whether a scene of the document is small enough to be made thousands of times. A small file may ask for
/// hundreds of megabytes of zeros, within the documented limits: that is not this target's question.
bool is_small(const Document& document)
{
    constexpr std::size_t kMostElements = 100'000;
    std::size_t elements = 0;
    for (const Accessor& accessor : document.accessors) elements += accessor.count;
    return elements <= kMostElements;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    bool small = false;
    attempt([&] {
        const Document document =
            read_document("fuzz", std::string(reinterpret_cast<const char*>(data), size), {});
        small = is_small(document);
        read_all(document);
    });
    if (!small) return 0;
    attempt([&] {
        const auto scene = std::make_shared<const Scene>(
            read_gltf("fuzz", std::string(reinterpret_cast<const char*>(data), size), {}, {}));
        World world;
        for (std::int32_t clip = PoseSettings::kRest; clip < std::int32_t(scene->clips.size());
             ++clip)
            for (const double time_s : {scene->begin_s(clip), 0.3, scene->end_s(clip)})
                attempt([&] { pose(scene, {.time_s = time_s, .clip = clip}, world); });
    });
    return 0;
}
