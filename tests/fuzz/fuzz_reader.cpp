// fuzz_reader.cpp - a reader meets any bytes: it makes a scene that can be posed, or says why not.
#include <firsthit/error.h>
#include <firsthit/scene.h>

#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

/// The file that each input is written to, in a folder of its own: readers take names.
const std::string& input_path()
{
    static const std::string path = [] {
        std::string folder = (std::filesystem::temp_directory_path() / "fuzz-XXXXXX").string();
        if (!mkdtemp(folder.data())) std::abort();
        static const std::string kept = folder;
        std::atexit([] {
            std::error_code ignored;
            std::filesystem::remove_all(kept, ignored);
        });
        return folder + "/input" FIRSTHIT_FUZZ_ENDING;
    }();
    return path;
}

/// What a scene promises: see scene.h.
void check_scene(const firsthit::Scene& scene)
{
    if (scene.owner.size() != scene.index.size()) std::abort();
    for (const glm::uvec3& corner : scene.index)
        for (int c = 0; c < 3; ++c)
            if (corner[c] >= scene.vertex_count()) std::abort();
    for (const std::uint32_t part : scene.owner)
        if (part >= scene.parts.size()) std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    std::ofstream(input_path(), std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    try {
        firsthit::LoadSettings settings;
        settings.sphere_segments = 4; // small scenes are fast scenes
        settings.cone_segments = 4;
        const firsthit::Scene scene = firsthit::load_scene(input_path(), settings);
        check_scene(scene);
        firsthit::World world;
        firsthit::pose(scene, 0.5 * (scene.begin_s + scene.end_s), world);
    } catch (const firsthit::Error&) {
        // A clear answer is what is asked for. Anything else that is thrown is a finding.
    }
    return 0;
}
