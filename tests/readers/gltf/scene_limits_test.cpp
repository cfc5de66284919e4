// scene_limits_test.cpp - small glTF files that would make scenes too large for the memory.
#include "message_of.h"
#include "readers/gltf/read_gltf.h"

#include <firsthit/error.h>

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace firsthit {
namespace {

/// So many nodes with one mesh of 30,000 vertices, all 0.
std::string nodes_with_a_mesh(int count, int primitives)
{
    std::string roots, nodes, mesh;
    for (int k = 0; k < count; ++k) {
        const std::string separator = k > 0 ? "," : "";
        roots += separator + std::to_string(k);
        nodes += separator + R"({"mesh":0,"name":"n"})";
    }
    for (int k = 0; k < primitives; ++k)
        mesh += std::string(k > 0 ? "," : "") + R"({"attributes":{"POSITION":0}})";
    return R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[)" + roots + R"(]}],"nodes":[)" +
           nodes + R"(],"meshes":[{"primitives":[)" + mesh +
           R"(]}],"accessors":[{"componentType":5126,"type":"VEC3","count":30000}]})";
}

TEST(GltfLimits, InstancesMayRepeatAMeshALot)
{
    const Scene scene = read_gltf("many", nodes_with_a_mesh(20, 1), {}, {});
    EXPECT_EQ(scene.instances.size(), 20u);
    EXPECT_EQ(scene.triangle_count(), 200'000u);
}

TEST(GltfLimits, InstancesThatRepeatTooMuchAreAnError)
{
    for (const auto& [nodes, primitives] :
        {std::pair(1000, 1), std::pair(1, 1000), std::pair(40, 25)})
        EXPECT_EQ(message_of<SceneError>(
                      [&] { read_gltf("many", nodes_with_a_mesh(nodes, primitives), {}, {}); }),
            "many: node 'n': instances repeat more than 16777216 vertices or triangles");
}

} // namespace
} // namespace firsthit
