// pose_corpus_test.cpp - poses of files that others made, against an evaluation that shares nothing with them.
#include "readers/gltf/pose_oracle.h"
#include "test_data.h"

#include <firsthit/error.h>
#include <firsthit/scene.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace firsthit {
namespace {

namespace fs = std::filesystem;

constexpr int kTimes = 10;

/// The farthest that a corner is from where the oracle has it, as a share of the model's size.
double farthest(const World& world, const OraclePose& oracle)
{
    const std::vector<glm::uvec3>& index = world.scene->index;
    EXPECT_EQ(3 * index.size(), oracle.corner.size());
    if (3 * index.size() != oracle.corner.size() || index.empty()) return 0;
    glm::dvec3 low(oracle.corner[0]), high(low);
    for (const glm::dvec3& p : oracle.corner) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    // Of a model far from the origin, floats are as fine as its place allows.
    const double size = std::max({glm::length(high - low), 1e-2 * glm::length(low), 1e-30});
    double worst = 0;
    for (std::size_t t = 0; t < index.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 p(world.position[index[t][k]]);
            worst = std::max(worst, glm::length(p - oracle.corner[3 * t + std::size_t(k)]) / size);
        }
    return worst;
}

/// returns  how many poses were compared
int compare(const fs::path& path)
{
    const std::optional<PoseOracle> oracle = PoseOracle::open(path);
    if (!oracle) return 0;
    std::shared_ptr<const Scene> scene;
    try {
        scene = std::make_shared<const Scene>(load_scene(path.string()));
    } catch (const Error&) {
        return 0; // what loads is another test's question
    }
    EXPECT_EQ(int(scene->clips.size()), oracle->animations());
    int poses = 0;
    World world;
    const auto check = [&](int clip, double time_s) {
        pose(scene, PoseSettings{.time_s = time_s, .clip = clip}, world);
        EXPECT_LE(farthest(world, oracle->pose(clip, time_s)), 1e-5)
            << "clip " << clip << " at " << time_s;
        ++poses;
    };
    check(PoseSettings::kRest, 0);
    for (int clip = 0; clip < oracle->animations(); ++clip) {
        const auto [begin_s, end_s] = oracle->range(clip);
        EXPECT_NEAR(scene->begin_s(clip), begin_s, 1e-6);
        EXPECT_NEAR(scene->end_s(clip), end_s, 1e-6);
        // Also before and after, and off the keys.
        for (int k = 0; k < kTimes; ++k)
            check(clip, begin_s + (end_s - begin_s) * (1.17 * k / (kTimes - 1) - 0.083));
    }
    return poses;
}

TEST(GltfPoses, AgreeWithAnEvaluationFromTheSpecification)
{
    int files = 0, poses = 0;
    for (const char* name : {"gltf", "corpus/gltf/khronos-samples", "corpus/gltf/blender-io",
             "corpus/gltf/asset-generator"}) {
        const std::optional<fs::path> folder = test_data(name);
        if (!folder) continue;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(*folder)) {
            const std::string extension = entry.path().extension().string();
            if (extension != ".gltf" && extension != ".glb") continue;
            if (entry.path().string().find("Negative") != std::string::npos) continue;
            SCOPED_TRACE(entry.path().string());
            const int compared = compare(entry.path());
            poses += compared;
            files += compared > 0;
        }
    }
    if (files == 0) GTEST_SKIP() << "no files: set FIRSTHIT_TEST_DATA";
    RecordProperty("files", files);
    RecordProperty("poses", poses);
    EXPECT_GT(poses, 500) << "the files are there, but hardly any was compared";
}

} // namespace
} // namespace firsthit
