// frames.cpp - makes frames under MemorySanitizer, which stops where a branch, an index or a film
// depends on memory that nobody wrote.
//
// A plain program: libstdc++'s streams and GoogleTest's are not instrumented, and would be reported.
#include "render/memory/memory_cases.h"

#include <firsthit/firsthit.h>

#include <sanitizer/msan_interface.h>

#include <cstdio>

int main()
{
    using namespace firsthit;
    using namespace firsthit::test;
    int frames = 0, number = 0;
    for (MemoryCase& shown : memory_cases()) {
        View& view = shown.made.view; // small: a frame takes a hundred times as long as it should
        view.width /= 2, view.height /= 2;
        for (const FrameKind& kind : frame_kinds(Engine::cpu)) {
            if (++number % 13 != 0) continue; // of 20 kinds, in turn
            std::fprintf(stderr, "%s: %s\n", shown.name.c_str(), kind.name.c_str());
            Settings settings = kind.settings;
            settings.tile_size = frames % 2 ? 16 : 64;
            Renderer renderer(2); // all its memory is fresh
            Film film;
            renderer.render(shown.made.world.world, view, settings, film);
            const std::vector<std::byte> bytes = bytes_of(film);
            __msan_check_mem_is_initialized(bytes.data(), bytes.size());
            ++frames;
        }
    }
    for (const ShadowScene& scene : shadow_scenes()) {
        std::fprintf(stderr, "points: %s\n", scene.name.c_str());
        const ShadowWorld made = make_shadow_world(scene, 5);
        const ShadowPoints points = shadow_points(made, 100, 11);
        Occlusion occlusion(2);
        std::vector<std::uint8_t> bits;
        occlusion.test_packed(
            made.world.world, points.point, made.world.world.lights, bits, points.receiver);
        __msan_check_mem_is_initialized(bits.data(), bits.size());
    }
    std::printf("%d frames, all from memory that was written\n", frames);
    return 0;
}
