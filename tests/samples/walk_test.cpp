// walk_test.cpp - robots walk: feet stay above the ground, and in place while they stand on it.
#include "samples/robots/walk.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace firsthit {
namespace {

glm::dmat4 matrix_at_key(const Track& track, std::size_t key)
{
    const glm::dvec4& q = track.rotation[key].value;
    return glm::translate(glm::dmat4(1), glm::dvec3(track.translation[key].value)) *
           glm::mat4_cast(glm::dquat(q.w, q.x, q.y, q.z));
}

/// The middle of a sole in the world.
glm::dvec3 sole(const WalkTracks& tracks, std::size_t side, std::size_t key, const RobotSize& robot)
{
    const glm::dmat4 world_from_foot =
        matrix_at_key(tracks.root, key) * matrix_at_key(tracks.hips, key) *
        matrix_at_key(tracks.thigh[side], key) * matrix_at_key(tracks.shin[side], key) *
        matrix_at_key(tracks.foot[side], key);
    return glm::dvec3(world_from_foot * glm::dvec4(0, -robot.ankle, 0, 1));
}

TEST(Walk, KeepsFeetAboveTheGroundAndStandingOnesInPlace)
{
    const RobotSize robot;
    Walk walk;
    walk.radius = 1000; // nearly straight: nothing turns under the feet
    walk.speed = 0.9;
    const WalkTracks tracks = make_walk("r", walk, robot, 0, 10);
    for (std::size_t side = 0; side < 2; ++side) {
        int standing = 0;
        const std::size_t keys = tracks.root.translation.size();
        for (std::size_t k = 1; k < keys; ++k) {
            const glm::dvec3 before = sole(tracks, side, k - 1, robot);
            const glm::dvec3 now = sole(tracks, side, k, robot);
            EXPECT_GT(now.y, -0.03); // a foot that tips goes around its ankle
            if (before.y > 1e-6 || now.y > 1e-6) continue;
            ++standing;
            EXPECT_LT(glm::length(now - before), 0.002);
        }
        EXPECT_GT(standing, static_cast<int>(keys) / 2);
    }
}

TEST(Walk, HasKeysAroundTheWholeTime)
{
    const Track track = sample_track("t", 0, 10, 0.3, [](double t) {
        return Placement{{t, 0, 0}, {1, 0, 0, 0}};
    });
    EXPECT_LE(track.translation[1].time_s, 0.0);
    EXPECT_GE(track.translation[track.translation.size() - 2].time_s, 10.0);
    EXPECT_EQ(track.translation.size(), track.rotation.size());
}

TEST(Walk, KeepsNeighbouringQuaternionsOnOneSide)
{
    Walk walk;
    walk.radius = 1;
    walk.speed = 2;
    const WalkTracks tracks = make_walk("r", walk, RobotSize{}, 0, 10);
    const auto& keys = tracks.root.rotation;
    for (std::size_t k = 1; k < keys.size(); ++k)
        EXPECT_GT(glm::dot(keys[k - 1].value, keys[k].value), 0.9);
}

} // namespace
} // namespace firsthit
