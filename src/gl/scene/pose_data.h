// pose_data.h - what gl/shaders/pose.comp reads, as it lies in buffers (std430).
#pragma once

#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>

namespace firsthit::gl {

/// Rows of what moves a node's vertices, as VertexMatrix (scene/animate/pose_kernel.h).
struct MatrixData {
    glm::vec4 world[3]{};  // world_from_node
    glm::vec4 normal[3]{}; // w unused

    bool operator==(const MatrixData&) const = default;
};
static_assert(offsetof(MatrixData, normal) == 48 && sizeof(MatrixData) == 96);

/// Where a part's vertices come from.
struct PartData {
    std::uint32_t matrix = 0; // number of its MatrixData: its node's
    std::uint32_t moving = 0; // 1: its vertices are in the moving arrays, in world space
    std::uint32_t first = 0;  // of its vertices there
    std::uint32_t first_vertex = 0;
    std::uint32_t vertex_count = 0;
    std::uint32_t material = 0;
};
static_assert(offsetof(PartData, first_vertex) == 12 && sizeof(PartData) == 24);

} // namespace firsthit::gl
