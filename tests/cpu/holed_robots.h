// holed_robots.h - frames of the robots, by items of which some are missing.
#pragma once

#include "cpu/frame.h"
#include "film/fill_holes.h"
#include "items.h"
#include "scene/model/borrow.h"

#include <firsthit/scene.h>

#include <functional>

namespace firsthit::test {

/// Our items, but samples are holes where `is_hole` says so.
class HoledSource final : public ItemSource {
  public:
    using IsHole = std::function<bool(int x, int y)>; // sample of the part
    explicit HoledSource(IsHole is_hole) : is_hole_(std::move(is_hole)) {}

    bool start(const World& world, ViewMemory& memory, Tasks& tasks) override
    {
        return ours_.start(world, memory, tasks);
    }
    std::size_t wait(const ViewMemory& memory) override { return ours_.wait(memory); }
    void tile(const ViewMemory& memory, int tile, TileItems& out, std::span<std::uint64_t> holes,
        std::size_t worker) override
    {
        ours_.tile(memory, tile, out, holes, worker);
        const int x0 = memory.first_x(tile), y0 = memory.first_y(tile);
        for (int y = 0; y < out.size && y0 + y < memory.pencil.height; ++y) {
            for (int x = 0; x < out.size && x0 + x < memory.pencil.width; ++x) {
                if (!is_hole_(x0 + x, y0 + y)) continue;
                const auto offset = std::size_t(tile_offset(x, y, out.size));
                out.item[offset] = kNoItem;
                holes[offset / 64] |= std::uint64_t(1) << offset % 64;
            }
        }
    }

  private:
    RasterSource ours_;
    IsHole is_hole_;
};

/// The robots, a few of their pixels.
struct Robots {
    Scene scene = load_scene("builtin:robots");
    World world;
    View view;

    Robots()
    {
        pose(borrow(scene), 1.5, world);
        view.width = 101, view.height = 67;
        view.camera = world.camera;
    }

    Rendered render(const Settings& settings, ItemSource* source = nullptr, int threads = 1) const
    {
        Tasks tasks(threads);
        FrameMemory memory;
        Rendered out;
        const View filled = checked(view);
        render_frame({world, filled, tasks, out.film}, settings, memory, out.stats, {source});
        return out;
    }

    std::size_t pixels() const { return std::size_t(view.width * view.height); }

    /// What filling these pixels makes of the picture.
    std::vector<float> filled(std::vector<float> color, const HoledSource::IsHole& is_hole) const
    {
        std::vector<std::uint8_t> hole;
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x) hole.push_back(is_hole(x, y));
        fill_holes({view.width, view.height, hole, color}, 0, view.height);
        return color;
    }
};

} // namespace firsthit::test
