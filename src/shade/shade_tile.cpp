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
#include "shade/run_textures-inl.h"
#include "shade/sample_normals-inl.h"
#include "shade/shade_block-inl.h"

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
    /// uv  whether texture coordinates will be asked for, and the positions with them
    RunPrefetch(const ShadeArrays& arrays, std::span<const HitRun> runs, bool uv)
        : arrays_(arrays),
          uv_(uv),
          runs_(arrays.scene->vertices > kCachedVertices && arrays.normal
                    ? runs
                    : std::span<const HitRun>())
    {
    }

    /// Of the runs after number `run`.
    ///
    /// reached  whether light has reached the block before: else these want no normals either
    HWY_INLINE void advance(std::size_t run, bool reached)
    {
        if (!uv_ && !reached) return;
        for (const std::size_t end = std::min(run + 2 * kAhead, runs_.size()); index_ < end;
             ++index_) {
            hwy::Prefetch(&arrays_.scene->index[runs_[index_].item]);
            hwy::Prefetch(&arrays_.scene->owner[runs_[index_].item]);
        }
        for (const std::size_t end = std::min(run + kAhead, runs_.size()); corner_ < end;
             ++corner_) {
            const HitRun& next = runs_[corner_];
            const glm::uvec3& corner = arrays_.scene->index[next.item];
            const bool with_position = uv_ || !next.has_plane();
            for (int k = 0; k < 3; ++k) {
                if (with_position) hwy::Prefetch(&arrays_.position[corner[k]]);
                hwy::Prefetch(&arrays_.normal[corner[k]]);
                if (uv_) hwy::Prefetch(&arrays_.uv[corner[k]]);
            }
        }
    }

  private:
    static constexpr std::size_t kAhead = 64;               // runs: a block of them
    static constexpr std::size_t kCachedVertices = 1 << 15; // 24 bytes each

    const ShadeArrays& arrays_;
    bool uv_;
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
///
/// textures  null: each run works out its own; else has the runs, from number `first` on
HWY_INLINE BlockMaterials find_surfaces(const TileShade& tile, std::span<const HitRun> runs,
    const RunTextures* textures, std::size_t first, std::uint64_t reached, bool planes,
    SampleCorners& corners, BlockSurface& surface)
{
    const ShadeArrays& arrays = tile.arrays;
    const Scene& scene = *arrays.scene;
    const bool one_by_one = !planes && arrays.normal && runs.size() >= kManyRuns;
    const bool with_uv = tile.targets.uv[0] != nullptr;

    BlockMaterials materials;
    for (const HitRun& run : runs) {
        const RunTextures::Run* found =
            textures ? &(*textures)[first + std::size_t(&run - runs.data())] : nullptr;
        const std::uint32_t material = found ? found->material : material_of(scene, run.item);
        materials.add(material, run.samples);
        const bool seen = planes || (run.samples & reached) != 0;
        if (seen) {
            HitRun spare;
            const HitRun& known = known_run(run, tile.world, tile.hits.rays.eye, spare);
            if (one_by_one)
                corners.set(scene.index[run.item], known,
                    runs.size() <= kMostRunLanes ? std::uint64_t(1) << (&run - runs.data())
                                                 : run.samples);
            else
                spread_normal(run_normal(arrays, scene.index[run.item], glm::vec3(known.plane)),
                    run, tile.hits, surface);
        }
        if (found) {
            if (found->texture)
                spread_uv(textures->uv(found->slot), textures->gradients(found->slot),
                    found->texture, run, tile.hits, surface);
            continue;
        }
        const Texture* texture = arrays.uv ? texture_of(scene, scene.materials[material]) : nullptr;
        if (!texture && !planes) continue;
        if (planes) spread_geometric(geometric_normal(arrays, run, tile.hits.rays), run, surface);
        if (!texture && !with_uv) continue;
        const RunPlane plane = run_plane(arrays, run.item, tile.hits.rays);
        const Interpolated<glm::vec2> uv = run_uv(arrays, plane.corner);
        RunGradients gradients;
        if (texture) gradients = run_gradients(plane, uv, tile.hits.rays);
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

/// Hits of whole pictures are kept longer than caches can hold them.
constexpr std::uint32_t kBlocksAhead = 4;

HWY_INLINE void prefetch_hits(const HitTile& hits, std::uint32_t block)
{
    constexpr int kLine = 64 / sizeof(float);
    if (block >= hits.blocks()) return;
    for (const float* plane : {hits.t, hits.u, hits.v})
        for (int k = 0; k < kBlockSamples; k += kLine)
            hwy::Prefetch(plane + block * std::uint32_t(kBlockSamples) + k);
}

void shade(const HitTile& hits, const World& world, const LightVisibility& lit,
    const ShadeTargets& targets)
{
    const ShadeLights lights(world.lights);
    const ShadeArrays arrays = shade_arrays(world);
    const TileShade tile{hits, world, arrays, lights, lit, targets};
    const bool planes = targets.uv[0] || targets.normal[0] || targets.geometric_normal[0] ||
                        targets.position[0] || targets.albedo[0];
    fill_background(hits, world.scene->background, targets);

    SampleCorners corners(world.position.size());
    BlockSurface surface = {};
    const bool ahead = !planes && arrays.uv && !world.scene->textures.empty();
    RunPrefetch prefetch(arrays, hits.runs, arrays.uv && !ahead);
    bool lit_before = true;
    RunTextures textures;
    std::size_t first_found = 0, found = 0; // runs that `textures` has
    for (std::size_t r = 0; r < hits.runs.size();) {
        // Runs of one block lie side by side, at most 64.
        const std::uint32_t block = hits.runs[r].block;
        std::size_t end = r + 1;
        while (end < hits.runs.size() && end - r < kBlockSamples && hits.runs[end].block == block)
            ++end;
        const std::span<const HitRun> runs = hits.runs.subspan(r, end - r);
        prefetch.advance(end, lit_before);
        const std::uint64_t reached = reached_samples(tile, block);
        lit_before = reached != 0;
        prefetch_hits(hits, block + kBlocksAhead);
        if (ahead && end > found) {
            first_found = r;
            found = std::min(hits.runs.size(), r + RunTextures::kRuns);
            textures.find(arrays, hits.rays, hits.runs.subspan(r));
        }
        const BlockMaterials materials = find_surfaces(tile, runs, ahead ? &textures : nullptr,
            r - first_found, reached, planes, corners, surface);
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

void shade_tile(const HitTile& hits, const World& world, const LightVisibility& lit,
    const ShadeTargets& targets)
{
    if (targets.any()) HWY_DYNAMIC_DISPATCH(shade)(hits, world, lit, targets);
}

} // namespace firsthit
#endif
