// layers.cpp - frames of scenes with blended surfaces.
#include "cpu/layers.h"

#include "cpu/adaptive/pixel_marks.h"
#include "cpu/finer_view.h"
#include "cpu/frame.h"
#include "exact/opacity.h"
#include "film/film_size.h"
#include "visibility/bin/project.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace firsthit {
namespace {

constexpr float kLeastThrough = 0x1p-24f; // what lets less through, lets nothing through
constexpr int kPart = 4096;               // samples on a side that are searched at once
constexpr std::size_t kGrain = 4096;      // samples of a task

/// Items that are known, as the source of a frame.
class KnownItems final : public ItemSource {
  public:
    /// whole  of all samples
    /// items  (height, width) of it
    KnownItems(const Pencil& whole, std::span<const std::uint32_t> items)
        : whole_(whole),
          items_(items)
    {
    }

    bool start(const World& world, ViewMemory& memory, Tasks& tasks) override
    {
        take_triangles(*world.scene, memory);
        memory.in_view_count = memory.entry_count = 0; // nothing is binned
        project_vertices(world.position, memory.pencil, memory, tasks);
        return true;
    }

    std::size_t wait(const ViewMemory& memory) override { return std::size_t(memory.tiles()); }

    void tile(const ViewMemory& memory, int tile, TileItems& out,
        std::span<std::uint64_t> /*holes*/, std::size_t /*worker*/) override
    {
        out.rays = memory.rays(tile);
        out.counts = {};
        const int left = memory.first_x(tile), top = memory.first_y(tile);
        const int part_x = int(memory.pencil.x0 - whole_.x0),
                  part_y = int(memory.pencil.y0 - whole_.y0);
        for (int y = 0; y < out.size; ++y) {
            for (int x = 0; x < out.size; ++x) {
                const bool inside =
                    left + x < memory.pencil.width && top + y < memory.pencil.height;
                const std::size_t at = std::size_t(part_y + top + y) * std::size_t(whole_.width) +
                                       std::size_t(part_x + left + x);
                out.item[std::size_t(tile_offset(x, y, out.size))] = inside ? items_[at] : kNoItem;
            }
        }
    }

  private:
    const Pencil& whole_;
    std::span<const std::uint32_t> items_;
};

/// The layers of one frame.
class Layers {
  public:
    /// view  its pixels are the samples
    /// only  the pixels whose samples have layers; null: all
    Layers(const World& world, const View& view, Tasks& tasks, LayerMemory& memory,
        const PixelMarks* only)
        : world_(world),
          view_(view),
          pencil_(pencil_of(world, view, view.region)),
          tasks_(tasks),
          memory_(memory)
    {
        const std::size_t samples = std::size_t(pencil_.width) * std::size_t(pencil_.height);
        memory_.item.resize(samples);
        memory_.through.resize(samples);
        memory_.sum.resize(samples);
        memory_.behind.resize(samples);
        std::fill_n(memory_.behind.data(), samples, 0.0f);
        std::fill_n(memory_.through.data(), samples, 1.0f);
        if (only) leave_out(*only);
        std::fill_n(memory_.sum.data(), samples, glm::vec3(0));
        for (const Material& material : world.scene->materials)
            is_blended_.push_back(material.alpha == AlphaMode::blend);
    }

    const Pencil& pencil() const { return pencil_; }

    /// Adds the layer of memory.item.
    ///
    /// color  (height, width, 3) of it
    void add(std::span<const float> color)
    {
        find_corners(pencil_, 1); // that of one sample finds all corners
        tasks_.for_ranges(memory_.item.size(), kGrain, [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last; ++k) {
                float& through = memory_.through[k];
                if (through == 0) continue;
                const float opaque = opacity_at(k);
                const float weight = through * opaque;
                if (memory_.item[k] == kNoItem) memory_.behind[k] = weight;
                for (int c = 0; c < 3; ++c)
                    memory_.sum[k][c] += weight * color[3 * k + std::size_t(c)];
                through = opaque < 1 ? through * (1 - opaque) : 0.0f;
                if (through < kLeastThrough) through = 0;
            }
        });
    }

    /// Makes memory.item the next layer. Returns whether there is one.
    bool find_next()
    {
        bool any = false;
        for (int y = 0; y < pencil_.height; y += kPart)
            for (int x = 0; x < pencil_.width; x += kPart)
                any |= find_next({x, y, std::min(kPart, pencil_.width - x),
                    std::min(kPart, pencil_.height - y)});
        return any;
    }

  private:
    static Pencil pencil_of(const World& world, const View& view, const Region& region)
    {
        Pencil pencil = firsthit::pencil_of(view, region, 1);
        reach_all(world.position, pencil);
        return pencil;
    }

    /// Lets nothing be seen at the samples of pixels that are not marked.
    void leave_out(const PixelMarks& marks)
    {
        const int n = marks.samples;
        for (int y = 0; y < pencil_.height; ++y)
            for (int x = 0; x < pencil_.width; ++x)
                if (!marks.has((view_.region.x + x) / n, (view_.region.y + y) / n))
                    memory_.through[index_of(x, y)] = 0;
    }

    /// Moves the triangles into the eye space of a pencil, of which a square of `size` samples is
    /// searched; 0: all.
    void find_corners(Pencil pencil, int size)
    {
        take_triangles(*world_.scene, memory_.mesh);
        if (size > 0) pencil.width = pencil.height = size;
        project_vertices(world_.position, pencil, memory_.mesh, tasks_);
    }

    /// Of the layer at a sample; the background is opaque.
    float opacity_at(std::size_t k) const
    {
        const std::uint32_t item = memory_.item[k];
        const Scene& scene = *world_.scene;
        if (item == kNoItem || !is_blended_[scene.instances[scene.owner[item]].material]) return 1;
        const auto width = std::size_t(pencil_.width);
        const glm::vec3 d = pencil_.tile(0, 0).direction(int(k % width), int(k / width));
        const auto [u, v] = memory_.mesh.cutouts.weights(corners_of(memory_.mesh, item), d);
        return std::min(opacity(scene, item, u, v), 1.0f);
    }

    /// The next layer in a rectangle of the samples.
    bool find_next(const Region& part)
    {
        memory_.open.clear();
        memory_.last.clear();
        for (int y = 0; y < part.height; ++y) {
            for (int x = 0; x < part.width; ++x) {
                const std::size_t k = index_of(part.x + x, part.y + y);
                if (memory_.through[k] > 0) {
                    memory_.open.push_back({std::uint16_t(x), std::uint16_t(y)});
                    memory_.last.push_back(memory_.item[k]);
                }
                memory_.item[k] = kNoItem;
            }
        }
        if (memory_.open.empty()) return false;
        const Region& all = view_.region;
        const Pencil pencil =
            pencil_of(world_, view_, {all.x + part.x, all.y + part.y, part.width, part.height});
        find_corners(pencil, 0);
        const std::span<const std::uint32_t> found = find_listed_items(
            pencil, memory_.mesh, {memory_.open, memory_.last}, memory_.lazy, tasks_);
        for (std::size_t k = 0; k < found.size(); ++k) {
            const ListedSample& at = memory_.open[k];
            memory_.item[index_of(part.x + at.x, part.y + at.y)] = found[k];
        }
        return true;
    }

    std::size_t index_of(int x, int y) const
    {
        return std::size_t(y) * std::size_t(pencil_.width) + std::size_t(x);
    }

    const World& world_;
    const View& view_;
    const Pencil pencil_;
    Tasks& tasks_;
    LayerMemory& memory_;
    std::vector<bool> is_blended_; // (materials)
};

/// The film's colours become the means of n x n samples.
void store_means(std::span<const glm::vec3> sample, int n, Film& film)
{
    const auto width = std::size_t(film.width), step = std::size_t(n);
    for (std::size_t k = 0; k < width * std::size_t(film.height); ++k) {
        glm::vec3 sum(0);
        for (std::size_t y = k / width * step; y < (k / width + 1) * step; ++y)
            for (std::size_t x = k % width * step; x < (k % width + 1) * step; ++x)
                sum += sample[y * width * step + x];
        for (int c = 0; c < 3; ++c)
            film.color.value[3 * k + std::size_t(c)] = sum[c] / float(n * n);
    }
}

/// The film's alphas become what the samples do not see of the background, in the mean.
void store_alphas(std::span<const float> behind, int n, Film& film)
{
    const auto width = std::size_t(film.width), step = std::size_t(n);
    film.alpha.channels = 1;
    film.alpha.value.resize(width * std::size_t(film.height));
    for (std::size_t k = 0; k < film.alpha.value.size(); ++k) {
        float sum = 0;
        for (std::size_t y = k / width * step; y < (k / width + 1) * step; ++y)
            for (std::size_t x = k % width * step; x < (k % width + 1) * step; ++x)
                sum += behind[y * width * step + x];
        film.alpha.value[k] = 1 - sum / float(n * n);
    }
}

} // namespace

bool has_layers(const World& world, const Settings& settings)
{
    return settings.color && settings.interleave == 1 && has_blended_triangles(*world.scene);
}

void render_layers(const FrameContext& frame, const Settings& settings, FrameMemory& memory,
    Stats& stats, const FrameSources& sources)
{
    const World& world = frame.world;
    LayerMemory& layers = memory.layers;
    const auto check = [&] {
        if (frame.progress) frame.progress->check();
    };
    const bool single = settings.samples == 1;
    const View view = finer(frame.view, settings.samples);
    Settings surfaces = settings; // of a frame of one layer
    surfaces.samples = 1;
    surfaces.aovs.clear();
    surfaces.interpolate = false;
    Settings items = surfaces;
    items.color = false;
    items.aovs = {Aov::item};
    items.shadows = Shadows::none;
    const auto film_of = [&](Film& film) { return FrameContext{world, view, frame.tasks, film}; };

    // The first layer, and the planes.
    Settings first = settings;
    first.color = single;
    if (single || !settings.aovs.empty()) render_surfaces(frame, first, memory, stats, sources);
    resize(frame.film, frame.view.region, {true, settings.aovs, world.lights.size()});
    check();
    if (!single) render_surfaces(film_of(layers.film), surfaces, memory, stats, sources);
    check();
    const bool has_items = single && !frame.film.item.empty();
    if (!has_items) render_surfaces(film_of(layers.seen), items, memory, stats, sources);
    const std::vector<std::uint32_t>& seen = has_items ? frame.film.item : layers.seen.item;

    Layers all(world, view, frame.tasks, layers, sources.only);
    std::copy(seen.begin(), seen.end(), layers.item.data());
    all.add(single ? frame.film.color.value : layers.film.color.value);
    while (all.find_next()) {
        check();
        KnownItems known(all.pencil(), layers.item.span());
        render_surfaces(film_of(layers.film), surfaces, memory, stats,
            {.items = &known, .maps = sources.maps, .edges = sources.edges, .only = sources.only});
        all.add(layers.film.color.value);
    }
    store_means(layers.sum.span(), settings.samples, frame.film);
    if (settings.alpha) store_alphas(layers.behind.span(), settings.samples, frame.film);
}

} // namespace firsthit
