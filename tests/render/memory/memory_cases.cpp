// memory_cases.cpp - small worlds and settings that together make frames use every kind of memory.
#include "scene/model/borrow.h"
#include "render/memory/memory_cases.h"

#include "cpu/adversarial_scenes.h"
#include "scene/model/default_light.h"

#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <random>
#include <utility>

namespace firsthit::test {
namespace {

/// A built-in scene with its own camera, or with one that sees the whole scene.
MemoryCase show(std::string name, Scene scene, double time_s, int width, int height)
{
    MemoryCase made{std::move(name), {}};
    made.made.world.scene = std::make_shared<Scene>(std::move(scene));
    World& world = made.made.world.world;
    pose(borrow(*made.made.world.scene), time_s, world);
    made.made.view.width = width;
    made.made.view.height = height;
    made.made.view.camera = world.camera;
    return made;
}

/// A coarse torus on a floor that is one triangle: silhouettes with few samples of a block, before
/// blocks that see nothing.
Scene torus_on_floor()
{
    constexpr int kSteps = 12;
    constexpr double kTube = 1.4795127;
    std::vector<glm::vec3> position;
    std::vector<glm::uvec3> index;
    const auto vertex = [](int ring, int side) {
        return std::uint32_t(ring % kSteps * kSteps + side % kSteps);
    };
    for (int ring = 0; ring < kSteps; ++ring)
        for (int side = 0; side < kSteps; ++side) {
            const double a = 2 * std::numbers::pi * ring / kSteps,
                         b = 2 * std::numbers::pi * side / kSteps;
            const double radius = 2 + kTube * std::cos(b);
            position.emplace_back(float(radius * std::cos(a)), float(kTube * std::sin(b)),
                float(radius * std::sin(a)));
            const std::uint32_t at = vertex(ring, side), opposite = vertex(ring + 1, side + 1);
            index.emplace_back(at, vertex(ring + 1, side), opposite);
            index.emplace_back(at, opposite, vertex(ring, side + 1));
        }
    const auto first = std::uint32_t(position.size());
    position.emplace_back(-50.0f, float(-kTube), -50.0f);
    position.emplace_back(50.0f, float(-kTube), -50.0f);
    position.emplace_back(0.0f, float(-kTube), 60.0f);
    index.emplace_back(first, first + 1, first + 2);
    return scene_from_arrays(std::move(position), std::move(index));
}

/// Triangles that break rasterisers, under a light that they hide from each other.
void add_adversarial(std::vector<MemoryCase>& cases)
{
    const std::vector<AdversarialScene>& scenes = adversarial_scenes();
    for (std::size_t k = 0; k < scenes.size(); k += 4) {
        MemoryCase made{scenes[k].name, {}};
        std::mt19937 random(7);
        scenes[k].fill(made.made.world, random);
        made.made.world.finish();
        made.made.world.world.lights.push_back(point_light({0.4, -0.7, -0.2}));
        made.made.view = straight_view(kSize, kSize, kSize);
        cases.push_back(std::move(made));
    }
}

} // namespace

std::vector<MemoryCase> memory_cases()
{
    std::vector<MemoryCase> cases;
    cases.push_back(show("torus on a floor", torus_on_floor(), 0, 128, 128));
    cases.push_back(show("builtin:torus", load_scene("builtin:torus"), 0, 100, 76));
    cases.push_back(show("builtin:robots", load_scene("builtin:robots"), 2.5, 96, 64));
    cases.push_back(show("builtin:wave", load_scene("builtin:wave?n=20000"), 0.5, 72, 64));
    for (const ShadowScene& scene : shadow_scenes())
        cases.push_back({scene.name, make_shadow_world(scene, 3)});
    add_adversarial(cases);
    return cases;
}

std::vector<FrameKind> frame_kinds(Engine engine)
{
    struct Way {
        const char* name;
        Shadows shadows;
        int filter;
    };
    constexpr std::array kWays = {Way{"no shadows", Shadows::none, 1}, Way{"maps", Shadows::map, 1},
        Way{"filtered maps", Shadows::map, 3}, Way{"exact shadows", Shadows::exact, 1}};
    std::vector<FrameKind> kinds;
    for (const Way& way : kWays) {
        if (way.shadows == Shadows::exact && engine == Engine::gpu) continue;
        Settings settings;
        settings.engine = engine;
        settings.shadows = way.shadows;
        settings.shadow_filter = way.filter;
        const auto add = [&](const char* what, const auto& change) {
            FrameKind kind{std::string(way.name) + ", " + what, settings};
            change(kind.settings);
            kinds.push_back(std::move(kind));
        };
        const auto all_planes = [](Settings& s) {
            for (int k = 0; k < kAovCount; ++k) s.aovs.push_back(Aov(k));
        };
        add("colour", [](Settings&) {});
        add("all planes", all_planes);
        add("colour, one pixel in 4", [](Settings& s) { s.interleave = 4; });
        add("2 x 2 samples and planes", [&](Settings& s) {
            s.samples = 2;
            all_planes(s);
        });
        add("light alone", [](Settings& s) {
            s.color = false;
            s.aovs = {Aov::lit};
        });
        if (engine == Engine::cpu) continue;
        add("exact items", [](Settings& s) { s.multisample = Multisample::exact; });
        add("holes", [](Settings& s) { s.multisample = Multisample::none; });
        if (engine == Engine::gpu)
            add("several passes", [](Settings& s) { s.opengl.passes = GpuPasses::multi; });
        else
            add("items at once", [](Settings& s) { s.opengl.readback = Readback::sync; });
    }
    return kinds;
}

std::vector<std::byte> bytes_of(const Film& film)
{
    std::vector<std::byte> bytes;
    const auto add = [&](const auto& values) {
        const std::size_t count = values.size() * sizeof values[0], at = bytes.size();
        bytes.resize(at + count);
        if (count > 0) std::memcpy(bytes.data() + at, values.data(), count);
    };
    add(film.color.value);
    add(film.item);
    for (const Plane& plane : film.aov) add(plane.value);
    return bytes;
}

} // namespace firsthit::test
