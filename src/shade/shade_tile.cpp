// shade_tile.cpp - computes the colours of a tile: for each block, first the interpolated
// attributes of its samples, then the colours of each material's samples.
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

#include "shade/environment_background-inl.h"
#include "shade/block_attributes-inl.h"
#include "shade/run_textures-inl.h"
#include "shade/sample_normals-inl.h"
#include "shade/shade_block-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// The samples of a block by material. A block has 64 samples, so at most 64 materials.
class BlockMaterials {
  public:
    /// Adds samples of a material. No sample may be added twice.
    void add(std::uint32_t material, std::uint64_t samples)
    {
        // Neighbouring runs mostly have the same material: compare with the newest first.
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

/// From this number of runs in a block on, normals are computed for each sample by itself
/// (measured).
constexpr std::size_t kManyRuns = 5;

/// Prefetches the vertex data of the runs ahead. If a scene's arrays are larger than the caches,
/// waiting for them would take most of the time.
class RunPrefetch {
  public:
    /// uv  whether texture coordinates, and therefore positions, will be needed
    RunPrefetch(const ShadeArrays& arrays, std::span<const HitRun> runs, bool uv)
        : arrays_(arrays),
          uv_(uv),
          runs_(arrays.scene->vertices > kCachedVertices && arrays.normal
                    ? runs
                    : std::span<const HitRun>())
    {
    }

    /// Prefetches the data of the runs after number `run`.
    ///
    /// reached  whether a light reached the previous block. If not, the next ones probably need no
    ///          normals either
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
    static constexpr std::size_t kAhead = 64;               // runs; a block has at most so many
    static constexpr std::size_t kCachedVertices = 1 << 15; // 24 bytes each

    const ShadeArrays& arrays_;
    bool uv_;
    std::span<const HitRun> runs_;
    std::size_t index_ = 0;
    std::size_t corner_ = 0;
};

/// Stores the normals of a block with many runs. kWhole: see fetch_vectors.
template <bool kWhole>
HWY_INLINE void spread_normals(const TileShade& tile, const ReachedRuns& reached,
    const SampleCorners& corners, BlockAttributes& attributes)
{
#if HWY_TARGET == HWY_AVX3
    if (reached.runs.size() <= kMostRunLanes) {
        sample_run_normals<kWhole>(tile.arrays, tile.hits, reached, corners, attributes);
        return;
    }
#endif
    sample_normals<kWhole>(tile.arrays, tile.hits, reached, corners, attributes);
}

/// Writes what maps and colours of vertices need of a run, except the first texture coordinates.
///
/// to_eye  the plane's normal towards the eye; null: normals and tangents are not needed
HWY_INLINE void spread_maps(const TileShade& tile, const HitRun& run, const MapNeeds& needs,
    const glm::vec4* to_eye, BlockAttributes& attributes)
{
    const ShadeArrays& arrays = tile.arrays;
    const glm::uvec3& corner = arrays.scene->index[run.item];
    if (arrays.color) spread_vector(run_color(arrays, corner), run, tile.hits, attributes.color);
    if (needs.tangent && to_eye)
        spread_tangent({arrays, corner, glm::vec3(*to_eye)}, run, tile.hits, attributes);
    if (!needs.uv[1]) return;
    const RunPlane plane = run_plane(arrays, run.item, tile.hits.rays);
    const Interpolated<glm::vec2> uv = run_uv1(arrays, corner);
    spread_uv_steps<1>({uv, run_gradients(plane, uv, tile.hits.pixel_rays()), nullptr}, run,
        tile.hits, attributes);
}

/// The textures of some runs that were found ahead of time. The runs of a block begin at number
/// `first`. Null: each run finds its own texture.
struct FoundTextures {
    const RunTextures* textures;
    std::size_t first;
};

/// Works out what the block's targets need of its runs' triangles.
HWY_INLINE BlockMaterials find_surfaces(const TileShade& tile, const ReachedRuns& block,
    const FoundTextures& ahead, SampleCorners& corners, BlockAttributes& attributes)
{
    const std::span<const HitRun> runs = block.runs;
    const std::uint64_t reached = block.samples;
    const RunTextures* const textures = ahead.textures;
    const std::size_t first = ahead.first;
    const bool planes = tile.planes;
    const ShadeArrays& arrays = tile.arrays;
    const Scene& scene = *arrays.scene;
    const bool one_by_one = !planes && arrays.normal && runs.size() >= kManyRuns;
    const bool with_uv = tile.targets.uv[0] != nullptr;
    const bool textured = (arrays.uv || arrays.uv1) && !scene.textures.empty();

    BlockMaterials materials;
    for (const HitRun& run : runs) {
        const RunTextures::Run* found =
            textures ? &(*textures)[first + std::size_t(&run - runs.data())] : nullptr;
        const std::uint32_t material = found ? found->material : material_of(scene, run.item);
        materials.add(material, run.samples);
        const bool has_maps =
            !found && textured && !kModels[scene.materials[material].model.index()].maps.empty();
        const MapNeeds needs = found      ? found->needs
                               : has_maps ? map_needs(arrays, scene.materials[material])
                                          : MapNeeds{};
        glm::vec4 to_eye(0);
        const bool seen = planes || (run.samples & reached) != 0;
        if (seen) {
            HitRun spare;
            const HitRun& known = known_run(run, tile.world, tile.hits.rays, spare);
            if (one_by_one)
                corners.set(scene.index[run.item], known,
                    runs.size() <= kMostRunLanes ? std::uint64_t(1) << (&run - runs.data())
                                                 : run.samples);
            else
                spread_vector(run_normal(arrays, scene.index[run.item], glm::vec3(known.plane)),
                    run, tile.hits, attributes.normal);
            if (needs.tangent) to_eye = glm::vec4(glm::vec3(known.plane), 0);
        }
        if (arrays.color || needs.tangent || needs.uv[1])
            spread_maps(tile, run, needs, seen ? &to_eye : nullptr, attributes);
        if (found) {
            if (found->texture)
                spread_uv(
                    {textures->uv(found->slot), textures->gradients(found->slot), found->texture},
                    run, tile.hits, attributes);
            else if (needs.uv[0])
                spread_uv_steps<0>(
                    {textures->uv(found->slot), textures->gradients(found->slot), nullptr}, run,
                    tile.hits, attributes);
            continue;
        }
        const Texture* texture =
            arrays.uv && !has_maps ? texture_of(scene, scene.materials[material]) : nullptr;
        const bool in_texture = texture || needs.uv[0];
        if (!in_texture && !planes) continue;
        if (planes)
            spread_geometric(geometric_normal(arrays, run, tile.hits.rays), run, attributes);
        if (!in_texture && !with_uv) continue;
        const RunPlane plane = run_plane(arrays, run.item, tile.hits.rays);
        const Interpolated<glm::vec2> uv = run_uv(arrays, plane.corner);
        RunGradients gradients;
        if (in_texture) gradients = run_gradients(plane, uv, tile.hits.pixel_rays());
        if (needs.uv[0])
            spread_uv_steps<0>({uv, gradients, nullptr}, run, tile.hits, attributes);
        else
            spread_uv({uv, gradients, texture}, run, tile.hits, attributes);
    }
    if (one_by_one) {
        if (corners.has_last)
            spread_normals<true>(tile, block, corners, attributes);
        else
            spread_normals<false>(tile, block, corners, attributes);
    }
    return materials;
}

/// With shadows, the hits of a whole picture are kept, and they are no longer in cache here.
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
    const bool planes = targets.any_plane();
    const Scene& scene = *world.scene;
    ShadeEnvironment environment;
    if (has_reflected_environment(scene)) environment = shade_environment(scene.environment);
    const TileShade tile{
        hits, world, arrays, lights, lit, targets, planes, environment, lit.lit && arrays.normal};
    fill_background(hits, scene.background, targets);
    if (targets.color[0] && shows_environment(scene)) fill_environment(hits, scene, targets);

    SampleCorners corners(world.position.size());
    BlockAttributes attributes = {};
    const bool ahead = !planes && arrays.uv && !world.scene->textures.empty();
    RunPrefetch prefetch(arrays, hits.runs, arrays.uv && !ahead);
    bool lit_before = true;
    RunTextures textures;
    std::size_t first_found = 0, found = 0; // `textures` has the runs [first_found, found)
    for (std::size_t r = 0; r < hits.runs.size();) {
        // The runs of a block are consecutive; there are at most 64.
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
            textures.find(arrays, hits.pixel_rays(), hits.runs.subspan(r));
        }
        const BlockMaterials materials = find_surfaces(tile, {runs, reached},
            {ahead ? &textures : nullptr, r - first_found}, corners, attributes);
        for (const BlockMaterials::Group& group : materials)
            shade_samples(
                tile, {block, runs, group.material, group.samples, reached, planes}, attributes);
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
