// edge_finder.cpp - remembers what the ray through the centre of each pixel sees.
#include "cpu/adaptive/edge_finder.h"

#include "cpu/adaptive/item_plane.h"
#include "exact/hit.h"
#include "hits/known_run.h"
#include "material/models.h"

#include <algorithm>
#include <type_traits>
#include <variant>

namespace firsthit {
namespace {

int blocks_over(int pixels)
{
    return (pixels + kBlock - 1) / kBlock;
}

/// Whether a material's colour comes from a texture.
bool has_textures(const Material& material)
{
    return texture_number(material) >= 0 ||
           std::visit(
               [](const auto& model) {
                   for (const ModelMap& map : kMapsOf<std::decay_t<decltype(model)>>)
                       if (map_of(model, map).texture >= 0) return true;
                   return false;
               },
               material.model);
}

/// Fills a number for each sample of a tile that says whether none of each light arrives, a part, or all.
void fill_lit(const HitTile& hits, const LightVisibility& lit, std::size_t lights,
    std::uint32_t* __restrict number)
{
    const std::size_t samples = std::size_t(hits.size) * std::size_t(hits.size);
    std::fill_n(number, samples, 0u);
    for (std::size_t l = 0; lit.lit && l < lights; ++l) {
        const float* share = lit.of_light(l);
        for (std::size_t k = 0; k < samples; ++k)
            number[k] = 3 * number[k] + (share[k] > 0 ? 1u : 0u) + (share[k] >= 1 ? 1u : 0u);
    }
    for (std::size_t k = 0; k < samples; ++k) number[k] = hits.item[k] == kNoItem ? 0 : number[k];
}

} // namespace

void EdgeSight::resize(int width, int height)
{
    const std::size_t pixels = std::size_t(width) * std::size_t(height);
    item.resize(pixels);
    kind.resize(pixels);
    lit.resize(pixels);
    w.resize(pixels);
    block.resize(std::size_t(blocks_over(width)) * std::size_t(blocks_over(height)));
}

namespace {

Pencil pencil_of_picture(const FrameContext& frame)
{
    Pencil pencil = pencil_of(frame.view, frame.view.region, 1);
    reach_all(frame.world.position, pencil);
    return pencil;
}

} // namespace

EdgeFinder::EdgeFinder(const FrameContext& frame, EdgeMemory& memory, PixelMarks& marks)
    : world_(frame.world),
      tasks_(frame.tasks),
      pencil_(pencil_of_picture(frame)),
      memory_(memory),
      marks_(marks),
      sight_(&memory.first)
{
    const Region& region = marks.region;
    memory.first.resize(region.width, region.height);
    memory.worker.resize(std::max(memory.worker.size(), std::size_t(tasks_.threads())));
    const Scene& scene = *world_.scene;
    memory.textured.resize(scene.instances.size());
    for (std::size_t k = 0; k < scene.instances.size(); ++k)
        memory.textured[k] = has_textures(scene.materials[scene.instances[k].material]);
}

void EdgeFinder::record(
    const PixelRect& rect, const HitTile& hits, const LightVisibility& lit, std::size_t worker)
{
    const int width = marks_.region.width;
    if (hits.runs.empty()) {
        for (int y = rect.film_y; y < rect.film_y + rect.height; ++y) {
            const std::size_t first =
                std::size_t(y) * std::size_t(width) + std::size_t(rect.film_x);
            std::fill_n(&sight_->kind[first], rect.width, kNoItem);
            std::fill_n(&sight_->lit[first], rect.width, 0u);
            std::fill_n(&sight_->w[first], rect.width, 0.0f);
        }
        record_blocks(rect, hits);
        return;
    }
    const std::size_t samples = std::size_t(hits.size) * std::size_t(hits.size);
    EdgeMemory::Worker& own = memory_.worker[worker];
    own.kind.resize(samples);
    own.w.resize(samples);
    own.lit.resize(samples);
    fill_lit(hits, lit, world_.lights.size(), own.lit.data());
    const Scene& scene = *world_.scene;
    for (std::size_t k = 0; k < samples; ++k) {
        own.w[k] = inverse_depth(hits.t[k]);
        own.kind[k] = kNoItem;
        if (hits.item[k] == kNoItem) continue;
        const std::uint32_t owner = scene.owner[hits.item[k]];
        own.kind[k] = owner << 1 | memory_.textured[owner];
    }
    const auto copy = [&](const auto* from, auto& to) {
        static_assert(sizeof(*from) == sizeof(float));
        const float* const plane[] = {reinterpret_cast<const float*>(from)};
        copy_rows(rect, hits.size, plane, {reinterpret_cast<float*>(to.data()), width, false});
    };
    copy(hits.item, sight_->item);
    copy(own.kind.data(), sight_->kind);
    copy(own.lit.data(), sight_->lit);
    copy(own.w.data(), sight_->w);
    record_blocks(rect, hits);
}

void EdgeFinder::record_blocks(const PixelRect& rect, const HitTile& hits)
{
    const int side = hits.size / kBlock, columns = blocks_over(marks_.region.width);
    const Scene& scene = *world_.scene;
    const HitRun* run = hits.runs.data();
    const HitRun* const end = run + hits.runs.size();
    for (int block = 0; block < side * side; ++block) {
        const HitRun* const first = run;
        while (run != end && run->block == block) ++run;
        const int x = block % side, y = block / side;
        if (x >= blocks_over(rect.width) || y >= blocks_over(rect.height)) continue;
        BlockSight& sight = sight_->block[std::size_t((rect.film_y / kBlock + y) * columns) +
                                          std::size_t(rect.film_x / kBlock + x)];
        sight = {};
        if (first == run) continue;
        const float* t = hits.t + block * kBlockSamples;
        float farthest = 0, nearest = t[0];
        for (int k = 0; k < kBlockSamples; ++k) {
            farthest = std::max(farthest, t[k]);
            nearest = std::min(nearest, t[k]);
        }
        sight.least_w = inverse_depth(farthest);
        sight.most_w = inverse_depth(nearest);
        if (run - first == 1 && sight.least_w > 0) sight.item = first->item;
        sight.owner = scene.owner[first->item];
        for (const HitRun* other = first; other != run; ++other) {
            HitRun spare;
            const glm::vec3 normal(known_run(*other, world_, hits.rays, spare).plane);
            if (other == first) sight.normal = normal / glm::length(normal);
            if (scene.owner[other->item] != sight.owner || !are_close(normal, sight.normal)) {
                sight.owner = BlockSight::kSeveral;
                break;
            }
        }
    }
}

} // namespace firsthit
