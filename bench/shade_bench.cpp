// shade_bench.cpp - milliseconds to shade a million samples, by the length of runs.
//
// Each run has a triangle of its own, and vertices are shared, as in a mesh. The mip level differs
// from run to run.
#include "base/simd_targets.h"
#include "scene/model/borrow.h"
#include "shade/shade_tile.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace firsthit {
namespace {

constexpr int kTile = 64;
constexpr int kTiles = 256; // a million samples

/// The run lengths asked for, as masks that tile a block.
std::vector<std::uint64_t> masks_of_length(int samples)
{
    std::vector<std::uint64_t> masks;
    std::uint64_t open = ~std::uint64_t(0);
    while (open != 0) {
        // Grow a patch from the first open sample: neighbours in the block, roughly square.
        std::uint64_t mask = 0;
        const int seed = std::countr_zero(open);
        for (int reach = 0; reach < 2 * kBlock && std::popcount(mask) < samples; ++reach)
            for (int k = 0; k < kBlockSamples && std::popcount(mask) < samples; ++k) {
                const int dx = std::abs(block_x(k) - block_x(seed));
                const int dy = std::abs(block_y(k) - block_y(seed));
                if (std::max(dx, dy) <= reach && (open >> k & 1)) mask |= std::uint64_t(1) << k;
            }
        masks.push_back(mask);
        open &= ~mask;
    }
    return masks;
}

/// A tile's worth of hits, which all tiles share; but each tile sees its own triangles.
struct ShadedPicture {
    Scene scene;
    World world;
    std::vector<std::vector<HitRun>> runs;
    alignas(64) float t[kTile * kTile];
    alignas(64) float u[kTile * kTile];
    alignas(64) float v[kTile * kTile];

    ShadedPicture(int samples_in_run, bool textured, int lights)
    {
        Phong material;
        material.specular = glm::vec3(0.3f);
        material.shininess = 20;
        if (textured) {
            scene.textures.emplace_back("one colour",
                Picture{256, 256, std::vector<std::uint32_t>(256 * 256, 0xFF8040C0u)});
            material.texture = 0;
        }
        scene.materials.emplace_back().model = material;
        scene.instances.emplace_back();
        for (int i = 0; i < lights; ++i)
            world.lights.push_back({.position = {i, 50, -10}, .color = glm::vec3(1.0f)});

        // Each run gets a triangle of its own; vertices are shared, as in a mesh.
        const std::vector<std::uint64_t> masks = masks_of_length(samples_in_run);
        std::uint32_t triangle = 0;
        for (int tile = 0; tile < kTiles; ++tile) {
            runs.emplace_back();
            for (std::uint32_t block = 0; block < 64; ++block)
                for (const std::uint64_t mask : masks) {
                    runs.back().push_back({triangle, static_cast<std::uint16_t>(block), 0, mask});
                    scene.index.emplace_back(triangle / 2, triangle / 2 + 1, triangle / 2 + 7);
                    ++triangle;
                }
        }
        scene.owner.assign(triangle, 0);
        for (std::uint32_t vertex = 0; vertex < triangle / 2 + 8; ++vertex) {
            const float x = static_cast<float>(vertex % 7);
            const float z = static_cast<float>(vertex % 5);
            world.position.emplace_back(x, -1.0f, z - 10.0f);
            world.normal.emplace_back(0.0f, 0.8f, 0.6f);
            scene.uv.emplace_back(x, z);
        }
        scene.vertices = world.position.size();
        world.scene = borrow(scene);
        for (int k = 0; k < kTile * kTile; ++k) {
            t[k] = 5.0f + static_cast<float>(k % 64) / 64.0f;
            u[k] = static_cast<float>(k % 8) / 32.0f;
            v[k] = static_cast<float>(k % 64) / 128.0f;
        }
    }

    HitTile hits() const
    {
        HitTile tile;
        tile.size = kTile;
        tile.rays.step_x = tile.rays.step_y = 1.0f / 1000.0f;
        tile.rays.down.y = -1;
        tile.rays.forward.z = -1;
        tile.t = t;
        tile.u = u;
        tile.v = v;
        return tile;
    }
};

void shade_picture(const ShadedPicture& picture, const LightVisibility& lit = {})
{
    alignas(64) static float color[3][kTile * kTile];
    ShadeTargets targets;
    for (int axis = 0; axis < 3; ++axis) targets.color[axis] = color[axis];
    HitTile hits = picture.hits();
    for (const std::vector<HitRun>& runs : picture.runs) {
        hits.runs = runs;
        shade_tile(hits, picture.world, lit, targets);
        benchmark::DoNotOptimize(color);
    }
}

void shade_a_million(benchmark::State& state)
{
    const ShadedPicture picture(int(state.range(0)), state.range(1) != 0, int(state.range(2)));
    for (auto _ : state) shade_picture(picture);
}
BENCHMARK(shade_a_million)
    ->ArgNames({"run", "textured", "lights"})
    ->ArgsProduct({{1, 6, 16, 64}, {0, 1}, {1}})
    ->Args({6, 0, 4})
    ->Unit(benchmark::kMillisecond);

/// Runs of 6 and one light of a kind (point, spot, directional), which reaches so many of each 64
/// samples; -1: without shadows.
void shade_a_million_by(benchmark::State& state)
{
    ShadedPicture picture(6, false, 1);
    Light& light = picture.world.lights[0];
    light.kind = Light::Kind(state.range(0));
    light.outer_rad = 1.5;
    alignas(64) static float share[kTile * kTile];
    for (int k = 0; k < kTile * kTile; ++k) share[k] = k % 64 < state.range(1) ? 1.0f : 0.0f;
    const LightVisibility lit{state.range(1) < 0 ? nullptr : share, kTile * kTile};
    for (auto _ : state) shade_picture(picture, lit);
}
BENCHMARK(shade_a_million_by)
    ->ArgNames({"kind", "lit"})
    ->ArgsProduct({{0, 1, 2}, {-1, 0, 32, 64}})
    ->Unit(benchmark::kMillisecond);

/// Runs of 6 and 1 light, on one instruction set.
void shade_a_million_on(benchmark::State& state)
{
    const std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
    if (std::size_t(state.range(0)) >= targets.size()) {
        state.SkipWithError("no such target here");
        return;
    }
    const std::int64_t target = targets[std::size_t(state.range(0))];
    state.SetLabel(hwy::TargetName(target));
    const ShadedPicture picture(6, state.range(1) != 0, 1);
    hwy::GetChosenTarget().Update(target);
    for (auto _ : state) shade_picture(picture);
    hwy::GetChosenTarget().DeInit();
}
BENCHMARK(shade_a_million_on)
    ->ArgNames({"target", "textured"})
    ->ArgsProduct({{0, 1, 2, 3}, {0, 1}})
    ->Unit(benchmark::kMillisecond);

} // namespace
} // namespace firsthit
