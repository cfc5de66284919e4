// items.h - item buffers of test worlds: ours, and the definition.
#pragma once

#include "cpu/frame.h"
#include "rays/brute.h"
#include "render/check_settings.h"
#include "visibility/bin/project.h"

#include <gtest/gtest.h>

namespace firsthit::test {

struct Rendered {
    Film film;
    Stats stats;
};

inline Rendered render_planes(const World& world, const View& view, std::vector<Aov> aovs,
    int threads = 1, int tile_size = 64)
{
    Tasks tasks(threads);
    FrameMemory memory;
    Settings settings;
    settings.color = false;
    settings.aovs = std::move(aovs);
    settings.tile_size = tile_size;
    Rendered rendered;
    const View filled = checked(view);
    render_frame({world, filled, tasks, rendered.film}, settings, memory, rendered.stats);
    return rendered;
}

inline std::vector<std::uint32_t> items_of(
    const World& world, const View& view, int threads = 1, int tile_size = 64)
{
    return render_planes(world, view, {Aov::item}, threads, tile_size).film.item;
}

/// Eye-space triangles of a world, as the oracles take them.
struct EyeWorld {
    ViewMemory memory;
    EyeTriangles triangles;

    EyeWorld(const World& world, const View& view)
    {
        Tasks tasks(1);
        const View filled = checked(view);
        memory.pencil = pencil_of(filled, filled.region, 1);
        reach_all(world.position, memory.pencil);
        take_triangles(*world.scene, memory);
        project_vertices(world.position, memory.pencil, memory, tasks);
        triangles = {
            memory.corner.span().first(world.position.size()), world.scene->index, &memory.cutouts};
    }

    EyeWorld(const EyeWorld&) = delete;
    EyeWorld& operator=(const EyeWorld&) = delete;

    glm::vec3 ray(int x, int y) const
    {
        return {float(memory.pencil.x0 + x), float(memory.pencil.y0 + y), 1.0f};
    }
};

/// What the item buffer is defined to be.
inline std::vector<std::uint32_t> brute_items(const World& world, const View& view)
{
    const EyeWorld eye(world, view);
    std::vector<std::uint32_t> items;
    Effort effort;
    for (int y = 0; y < eye.memory.pencil.height; ++y)
        for (int x = 0; x < eye.memory.pencil.width; ++x)
            items.push_back(cast_brute(eye.triangles, eye.ray(x, y), effort));
    return items;
}

/// The number of samples at which two item buffers differ; prints the first few.
inline std::size_t differences(
    const std::vector<std::uint32_t>& ours, const std::vector<std::uint32_t>& theirs, int width)
{
    EXPECT_EQ(ours.size(), theirs.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        if (ours[i] == theirs[i]) continue;
        if (++count <= 5)
            ADD_FAILURE() << "sample (" << i % std::size_t(width) << ", " << i / std::size_t(width)
                          << "): ours " << int(ours[i]) << ", oracle " << int(theirs[i]);
    }
    return count;
}

} // namespace firsthit::test
