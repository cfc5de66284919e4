// scene_parts.h - what tests ask of scenes that readers made.
#pragma once

#include <firsthit/scene.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

namespace firsthit::test {

/// Where the k-th corner of a triangle is, in object space.
inline glm::vec3 corner(const Scene& scene, std::size_t triangle, int k)
{
    return scene.position[scene.index[triangle][k]];
}

/// The only warning, which must be there.
inline std::string warning_of(const Scene& scene)
{
    EXPECT_EQ(scene.warnings.size(), 1u);
    return scene.warnings.empty() ? "" : scene.warnings[0];
}

} // namespace firsthit::test
