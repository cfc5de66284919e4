// pose_bench.cpp - what a pose takes: skinned and morphed vertices on one thread, and a file's own clip.
//
// Usage: pose_bench, with FIRSTHIT_POSE_FILE=model.glb to pose that file too.
#include <firsthit/scene_builder.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <utility>

namespace firsthit {
namespace {

constexpr std::uint32_t kJoints = 24;

/// A cloth whose vertices follow `influences` of 24 joints, which turn, or that has morph targets.
std::shared_ptr<const Scene> cloth(std::uint32_t vertices, int influences, int targets)
{
    SceneBuilder builder("cloth");
    Mesh mesh;
    const auto side = static_cast<std::uint32_t>(std::sqrt(double(vertices)));
    for (std::uint32_t k = 0; k < side * side; ++k) {
        const float x = float(k % side) / float(side), z = float(k / side) / float(side);
        mesh.position.emplace_back(x, 0, z);
        mesh.normal.emplace_back(0, 1, 0);
        for (int i = 0; i < influences; ++i) {
            // Neighbours follow the same joints, as in a body.
            const auto first = static_cast<std::uint32_t>(x * float(kJoints - 8));
            mesh.shape.skin.joint.push_back(std::uint16_t(first + std::uint32_t(i)));
            mesh.shape.skin.weight.push_back(1.0f / float(influences));
        }
    }
    mesh.shape.skin.influences = influences;
    for (std::uint32_t r = 0; r + 1 < side; ++r)
        for (std::uint32_t c = 0; c + 1 < side; ++c) {
            const std::uint32_t a = r * side + c;
            mesh.index.emplace_back(a, a + side, a + side + 1);
        }
    for (int t = 0; t < targets; ++t) {
        MorphTarget& target = mesh.shape.targets.emplace_back();
        target.position.assign(mesh.position.size(), {0, 0.1f * float(t), 0});
        target.normal.assign(mesh.position.size(), {0.1f, 0, 0});
        mesh.shape.weights.push_back(0.5f);
    }
    Skin skin;
    Clip clip;
    clip.end_s = 1;
    const std::uint32_t root = builder.add_node({.name = "cloth"});
    for (std::uint32_t j = 0; j < kJoints; ++j) {
        const std::uint32_t joint = builder.add_node(
            {.name = "joint", .parent = std::int32_t(root), .transform = NodeTransform{}});
        skin.joints.push_back(joint);
        skin.inverse_bind.emplace_back(1);
        Channel turn;
        turn.node = joint;
        turn.path = Channel::Path::rotation;
        turn.time_s = {0, 1};
        turn.value = {0, 0, 0, 1, 0.1, 0, 0, 0.995};
        clip.channels.push_back(turn);
    }
    builder.add_clip(std::move(clip));
    const std::int32_t number =
        influences > 0 ? std::int32_t(builder.add_skin(std::move(skin))) : -1;
    builder.add_instance(builder.add_mesh(std::move(mesh)), root, builder.add_material({}), number);
    return std::make_shared<const Scene>(builder.build());
}

void pose_scene(benchmark::State& state, const std::shared_ptr<const Scene>& scene)
{
    World world;
    double time_s = scene->begin_s();
    const double step_s = (scene->end_s() - scene->begin_s()) / 97;
    for (auto _ : state) {
        pose(scene, time_s, world);
        time_s += step_s;
        if (time_s > scene->end_s()) time_s = scene->begin_s();
        benchmark::DoNotOptimize(world.position.data());
    }
    state.counters["ns/vertex"] = benchmark::Counter(double(scene->vertices) * 1e-9,
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void skinned(benchmark::State& state)
{
    pose_scene(state, cloth(std::uint32_t(state.range(0)), int(state.range(1)), 0));
}

void morphed(benchmark::State& state)
{
    pose_scene(state, cloth(std::uint32_t(state.range(0)), 0, int(state.range(1))));
}

void file(benchmark::State& state)
{
    const char* name = std::getenv("FIRSTHIT_POSE_FILE");
    if (!name) {
        state.SkipWithError("set FIRSTHIT_POSE_FILE");
        return;
    }
    pose_scene(state, std::make_shared<const Scene>(load_scene(name)));
}

BENCHMARK(skinned)
    ->Args({3'000, 4})
    ->Args({1'000'000, 4})
    ->Args({1'000'000, 8})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(morphed)->Args({1'000'000, 1})->Args({1'000'000, 4})->Unit(benchmark::kMillisecond);
BENCHMARK(file)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace firsthit
