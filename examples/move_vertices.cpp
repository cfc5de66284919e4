// move_vertices.cpp - moves the vertices of a scene from arrays in every frame, and reads which triangle
// each pixel sees.
// Only for the cpu engine: those on OpenGL take rigid parts from the scene and its matrices, so that they
// would draw the positions that were there before.
#include <firsthit/firsthit.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

int main()
{
    // A sheet of 2 m x 2 m in 100 x 100 cells. Normals are given, so that triangles share vertices.
    constexpr unsigned kCells = 100;
    std::vector<glm::vec3> position;
    std::vector<glm::uvec3> index;
    for (unsigned v = 0; v < (kCells + 1) * (kCells + 1); ++v) {
        const unsigned x = v % (kCells + 1), y = v / (kCells + 1);
        position.emplace_back(0.02f * float(x) - 1, 0.02f * float(y) - 1, 0);
        if (x == kCells || y == kCells) continue;
        index.emplace_back(v, v + 1, v + kCells + 2);
        index.emplace_back(v, v + kCells + 2, v + kCells + 1);
    }
    const std::vector<glm::vec3> normal(position.size(), glm::vec3(0, 0, 1));
    firsthit::World world;
    firsthit::pose(firsthit::scene_from_arrays(position, index, normal), 0, world);

    firsthit::View view;
    view.camera = {.eye = {0, -2, 2}, .direction = {0, 2, -2}, .up = {0, 0, 1}};
    view.width = view.height = 256;
    firsthit::Settings settings;
    settings.aovs = {firsthit::Aov::item, firsthit::Aov::position};
    firsthit::Renderer renderer;
    firsthit::Film film; // its memory is reused from frame to frame

    const auto wave = [](float x, float y, float t) { return 0.1f * std::sin(x * x + 5 * y - t); };
    bool right = true;
    for (int frame = 0; frame < 5; ++frame) {
        const float time = 0.8f * float(frame);
        for (glm::vec3& p : world.position) p.z = wave(p.x, p.y, time);
        firsthit::update_normals(world, renderer.threads());
        renderer.render(world, view, settings, film);

        float error = 0; // between what pixels see and the wave itself
        int seen = 0;
        for (std::size_t pixel = 0; pixel < film.item.size(); ++pixel) {
            if (film.item[pixel] == firsthit::kNoItem) continue;
            ++seen;
            const float* p = &film[firsthit::Aov::position].value[3 * pixel];
            error = std::max(error, std::abs(p[2] - wave(p[0], p[1], time)));
        }
        const std::uint32_t centre = film.item[128 * 256 + 128];
        std::printf("frame %d: %d pixels see the sheet, the middle one triangle %u; %.2g m off\n",
            frame, seen, centre, double(error));
        right = right && centre != firsthit::kNoItem && error < 1e-3f;
    }
    return right ? 0 : 1;
}
