// fuzz_aff.cpp - AFF scenes of any bytes: they are read and posed, or refused by an error of ours.
#include "readers/aff/aff.h"

#include <firsthit/error.h>
#include <firsthit/scene.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

namespace {

/// The input is several files, one after the other, between bytes of zero: the main one, "1", "2"
/// ...
std::vector<std::string> split(std::string_view bytes)
{
    std::vector<std::string> files;
    while (true) {
        const std::size_t end = bytes.find('\0');
        files.emplace_back(bytes.substr(0, end));
        if (end == std::string_view::npos) return files;
        bytes.remove_prefix(end + 1);
    }
}

void require(bool condition)
{
    if (!condition) std::abort();
}

/// What readers promise of a scene.
void check(const firsthit::Scene& scene)
{
    require(scene.position.size() == scene.vertices && scene.normal.size() == scene.vertices);
    require(scene.uv.empty() || scene.uv.size() == scene.vertices);
    require(scene.owner.size() == scene.index.size());
    for (std::size_t t = 0; t < scene.index.size(); ++t) {
        const firsthit::Instance& instance = scene.instances.at(scene.owner[t]);
        require(
            t >= instance.first_triangle && t - instance.first_triangle < instance.triangle_count);
        require(instance.material < scene.materials.size());
        for (int c = 0; c < 3; ++c)
            require(scene.index[t][c] >= instance.first_vertex &&
                    scene.index[t][c] - instance.first_vertex < instance.vertex_count);
    }
    for (const firsthit::Material& material : scene.materials)
        require(std::get<firsthit::Phong>(material.model).texture <
                static_cast<std::int64_t>(scene.textures.size()));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::vector<std::string> inputs = split({reinterpret_cast<const char*>(data), size});
    const firsthit::AffFiles files = {.include_text =
                                          [&](const std::string& name) {
                                              const std::size_t number =
                                                  std::strtoul(name.c_str(), nullptr, 10);
                                              if (number == 0 || number >= inputs.size())
                                                  throw firsthit::FileError("no such file");
                                              return inputs[number];
                                          },
        .texture =
            [](const std::string& name) {
                if (name != "t") throw firsthit::FileError("no such file");
                return firsthit::Texture(name, firsthit::Picture{1, 1, {0}});
            }};
    try {
        const auto scene = std::make_shared<const firsthit::Scene>(firsthit::parse_aff(
            "main", inputs[0], files, {.sphere_segments = 4, .cone_segments = 4}));
        check(*scene);
        firsthit::World world;
        for (const double time_s : {scene->begin_s(), 0.5, scene->end_s()})
            firsthit::pose(scene, time_s, world);
    } catch (const firsthit::Error& error) {
        require(*error.what() != '\0');
    }
    return 0;
}
