// shade_tile.cpp - what colour is it? Block by block: spread the runs, then light each material.
#include "shade/shade_tile.h"

#include "hits/known_run.h"
#include "shade/run_setup.h"
#include "shade/shade_light.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shade/shade_tile.cpp"
#include "base/simd.h"

#include <hwy/cache_control.h>

#include "shade/background-inl.h"
#include "shade/block_surface-inl.h"
#include "shade/phong_block-inl.h"
#include "shade/sample_normals-inl.h"

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

/// Runs of a block from which on its samples are worked out one by one (measured).
constexpr std::size_t kManyRuns = 5;

/// Fetches what the runs to come will need into the cache, ahead of them: where arrays are larger
/// than the caches, waiting for them is most of the time.
class RunPrefetch {
  public:
    RunPrefetch(const ShadeArrays& arrays, std::span<const HitRun> runs)
        : arrays_(arrays),
          runs_(arrays.scene->vertices > kCachedVertices && arrays.normal
                    ? runs
                    : std::span<const HitRun>())
    {
    }

    /// Of the runs after number `run`.
    HWY_INLINE void advance(std::size_t run)
    {
        for (const std::size_t end = std::min(run + 2 * kAhead, runs_.size()); index_ < end;
             ++index_) {
            hwy::Prefetch(&arrays_.scene->index[runs_[index_].item]);
            hwy::Prefetch(&arrays_.scene->owner[runs_[index_].item]);
        }
        for (const std::size_t end = std::min(run + kAhead, runs_.size()); corner_ < end;
             ++corner_) {
            const HitRun& next = runs_[corner_];
            const glm::uvec3& corner = arrays_.scene->index[next.item];
            const bool with_position = arrays_.uv || !next.has_plane();
            for (int k = 0; k < 3; ++k) {
                if (with_position) hwy::Prefetch(&arrays_.position[corner[k]]);
                hwy::Prefetch(&arrays_.normal[corner[k]]);
                if (arrays_.uv) hwy::Prefetch(&arrays_.uv[corner[k]]);
            }
        }
    }

  private:
    static constexpr std::size_t kAhead = 64;               // runs: a block of them
    static constexpr std::size_t kCachedVertices = 1 << 15; // 24 bytes each

    const ShadeArrays& arrays_;
    std::span<const HitRun> runs_;
    std::size_t index_ = 0;
    std::size_t corner_ = 0;
};

/// Writes the normals of a block with many runs. See fetch_vectors about kWhole.
template <bool kWhole>
HWY_INLINE void spread_normals(const TileShade& tile, std::span<const HitRun> runs,
    std::uint64_t reached, const SampleCorners& corners, BlockSurface& surface)
{
#if HWY_TARGET == HWY_AVX3
    if (runs.size() <= kMostRunLanes) {
        sample_run_normals<kWhole>(tile.arrays, tile.hits, runs, reached, corners, surface);
        return;
    }
#endif
    sample_normals<kWhole>(tile.arrays, tile.hits, runs[0].block, reached, corners, surface);
}

/// Works out what the block's targets need of its runs' triangles.
HWY_INLINE BlockMaterials find_surfaces(const TileShade& tile, std::span<const HitRun> runs,
    std::uint64_t reached, bool planes, SampleCorners& corners, BlockSurface& surface)
{
    const ShadeArrays& arrays = tile.arrays;
    const Scene& scene = *arrays.scene;
    const bool one_by_one = !planes && arrays.normal && runs.size() >= kManyRuns;
    const bool with_uv = tile.targets.uv[0] != nullptr;

    BlockMaterials materials;
    for (const HitRun& run : runs) {
        const std::uint32_t material =
            scene.materials.size() == 1 ? 0 : scene.parts[scene.owner[run.item]].material;
        materials.add(material, run.samples);
        const Texture* texture = arrays.uv ? texture_of(scene, scene.materials[material]) : nullptr;
        const bool seen = planes || (run.samples & reached) != 0;
        if (seen) {
            HitRun spare;
            const HitRun& known = known_run(run, tile.world, tile.hits.frame.eye, spare);
            if (one_by_one)
                corners.set(scene.index[run.item], known,
                    runs.size() <= kMostRunLanes ? std::uint64_t(1) << (&run - runs.data())
                                                 : run.samples);
            else
                spread_normal(run_normal(arrays, scene.index[run.item], glm::vec3(known.plane)),
                    run, tile.hits, surface);
        }
        if (!texture && !planes) continue;
        const RunPlane plane = run_plane(arrays, run.item, tile.hits.frame);
        if (planes) spread_geometric(geometric_normal(plane), run, surface);
        if (!texture && !with_uv) continue;
        const Interpolated<glm::vec2> uv = run_uv(arrays, plane.corner);
        RunGradients gradients;
        if (texture) gradients = run_gradients(plane, uv, tile.hits.frame);
        spread_uv(uv, gradients, texture, run, tile.hits, surface);
    }
    if (one_by_one) {
        if (corners.has_last)
            spread_normals<true>(tile, runs, reached, corners, surface);
        else
            spread_normals<false>(tile, runs, reached, corners, surface);
    }
    return materials;
}

void shade(const HitTile& hits, const World& world, const LitTile& lit, const ShadeTargets& targets)
{
    const ShadeLights lights(world.lights);
    const ShadeArrays arrays = shade_arrays(world);
    const TileShade tile{hits, world, arrays, lights, lit, targets};
    const bool planes = targets.uv[0] || targets.normal[0] || targets.geometric_normal[0] ||
                        targets.position[0] || targets.albedo[0];
    fill_background(hits, world.scene->background, targets);

    SampleCorners corners(world.position.size());
    BlockSurface surface = {};
    RunPrefetch prefetch(arrays, hits.runs);
    for (std::size_t r = 0; r < hits.runs.size();) {
        // Runs of one block lie side by side, at most 64.
        const std::uint32_t block = hits.runs[r].block;
        std::size_t end = r + 1;
        while (end < hits.runs.size() && end - r < kBlockSamples && hits.runs[end].block == block)
            ++end;
        const std::span<const HitRun> runs = hits.runs.subspan(r, end - r);
        prefetch.advance(end);
        const std::uint64_t reached = reached_samples(tile, block);
        const BlockMaterials materials =
            find_surfaces(tile, runs, reached, planes, corners, surface);
        for (const BlockMaterials::Group& group : materials)
            shade_samples(
                tile, {block, runs, group.material, group.samples, reached, planes}, surface);
        r = end;
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
