// fuzz_sequence.cpp - names of numbered files and two frames, made of anything: "NAME\0OBJ\0OBJ". What is between
// two frames is a sound scene.
#include "readers/mesh_file.h"
#include "readers/sequence/flatten.h"
#include "readers/sequence/sequence_frame.h"
#include "scene/model/check_scene.h"

#include <firsthit/error.h>
#include <firsthit/file_pattern.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace firsthit {
namespace {

/// The bytes up to the next zero, which are taken away.
std::string_view part_of(std::string_view& bytes)
{
    const std::string_view part = bytes.substr(0, bytes.find('\0'));
    bytes.remove_prefix(std::min(bytes.size(), part.size() + 1));
    return part;
}

void check_name(std::string_view text)
{
    try {
        const FilePattern pattern{std::string(text)};
        if (pattern.name(123456789).find("123456789") == std::string::npos) std::abort();
        if (pattern.name(1) == pattern.name(2)) std::abort();
    } catch (const ArgumentError&) {
        // Refused with a reason: what is no pattern should meet.
    }
}

SequenceFrame frame_of(std::string_view bytes)
{
    Scene scene = read_mesh(std::string(bytes), ".obj", "fuzz", {}, {});
    flatten(scene);
    SequenceFrame frame;
    frame.topology = std::make_shared<const Topology>(topology_of(scene, {}));
    frame.scene = std::make_shared<const Scene>(std::move(scene));
    return frame;
}

} // namespace
} // namespace firsthit

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace firsthit;
    std::string_view bytes(reinterpret_cast<const char*>(data), size);
    check_name(part_of(bytes));
    try {
        const SequenceFrame a = frame_of(part_of(bytes));
        const SequenceFrame b = frame_of(part_of(bytes));
        const std::optional<CornerMap> map = match(*a.topology, *b.topology);
        if (!map) return 0;
        const auto between = std::make_shared<const Scene>(scene_between(a, b, *map, 1, 2));
        check_scene(*between);
        World world;
        for (const double time_s : {1.0, 1.3, 2.0}) pose(between, time_s, world);
        if (between->triangle_count() != a.scene->triangle_count()) std::abort();
    } catch (const Error&) {
        // As above.
    }
    return 0;
}
