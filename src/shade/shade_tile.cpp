// shade_tile.cpp - what colour is it? Block by block: spread the runs, then light each material.
#include "shade/shade_tile.h"

#include "base/srgb.h"
#include "shade/run_setup.h"
#include "shade/shade_light.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shade/shade_tile.cpp"
#include "base/simd.h"

#include "shade/background-inl.h"
#include "shade/block_surface-inl.h"
#include "shade/phong_block-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// The samples of each material in a block, at most 64 different ones.
class BlockMaterials {
  public:
    /// Callers see to it that every call brings samples that no other call has.
    void add(std::uint32_t material, std::uint64_t samples)
    {
        // Neighbours mostly share their material: look at the newest first.
        for (int i = count_ - 1; i >= 0; --i)
            if (group_[i].material == material) {
                group_[i].samples |= samples;
                return;
            }
        group_[count_++] = {material, samples};
    }
    bool full() const { return count_ == kBlockSamples; }

    struct Group {
        std::uint32_t material;
        std::uint64_t samples;
    };
    const Group* begin() const { return group_; }
    const Group* end() const { return group_ + count_; }

  private:
    int count_ = 0;
    Group group_[kBlockSamples];
};

void shade(const HitTile& hits, const World& world, const LitTile& lit, const ShadeTargets& targets)
{
    const ShadeLights lights(world.lights);
    const TileShade tile{hits, world, lights, lit, targets, linear_from_srgb().data()};
    const ShadeArrays arrays = shade_arrays(world);
    fill_background(hits, world.scene->background, targets);

    BlockSurface surface = {};
    for (std::size_t r = 0; r < hits.runs.size();) {
        // Runs of one block lie side by side.
        BlockMaterials materials;
        const std::uint32_t block = hits.runs[r].block;
        for (; r < hits.runs.size() && hits.runs[r].block == block && !materials.full(); ++r) {
            const HitRun& run = hits.runs[r];
            const RunSetup setup = set_up_run(arrays, run.item, hits.frame);
            const Texture* texture =
                arrays.uv ? texture_of(*world.scene, world.scene->materials[setup.material])
                          : nullptr;
            spread_run(setup, run, hits, texture, targets.uv[0] != nullptr, surface);
            materials.add(setup.material, run.samples);
        }
        for (const BlockMaterials::Group& group : materials)
            shade_samples(tile, block, group.material, group.samples, surface);
    }
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(shade);

void shade_tile(
    const HitTile& hits, const World& world, const LitTile& lit, const ShadeTargets& targets)
{
    if (targets.any()) HWY_DYNAMIC_DISPATCH(shade)(hits, world, lit, targets);
}

} // namespace firsthit
#endif
