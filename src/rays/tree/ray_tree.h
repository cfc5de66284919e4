// ray_tree.h - a wide bounding volume hierarchy over the triangles of a posed scene, for rays that are no pencil.
//
// A node has up to eight children, whose boxes lie side by side for SIMD. A leaf is a block of up to eight
// triangles. Boxes are the exact bounds of float corners, so nothing is rounded. The topology is built once, by
// the surface area heuristic with bins; when positions change, boxes and corners are refitted.
//
// source  Wald 2007, "On fast Construction of SAH-based Bounding Volume Hierarchies"; Wald, Benthin and Boulos
//         2008, "Getting Rid of Packets" (wide nodes for single rays)
#pragma once

#include "base/tasks.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace firsthit {

inline constexpr int kWide = 8;     // children of a node
inline constexpr int kPerLeaf = 8;  // triangles of a leaf, at most
inline constexpr int kDeepest = 96; // nodes from the root to a leaf, at most

/// A node's child: a node, a leaf, or none.
struct TreeChild {
    static constexpr std::uint32_t kNone = 0xFFFFFFFF, kLeaf = 0x80000000;

    std::uint32_t value = kNone;

    bool is_leaf() const { return (value & kLeaf) != 0; }  // or none
    std::uint32_t index() const { return value & ~kLeaf; } // of the node or block
};

struct alignas(64) TreeNode {
    // Of each child: its box, lower corner x, y, z, then upper. A child that is not there has an empty one.
    float bound[6][kWide];
    TreeChild child[kWide];
};

/// The triangles of a leaf, their corners beside each other.
struct alignas(32) TriangleBlock {
    float corner[9][kPerLeaf];        // x, y, z of corners 0, 1 and 2
    std::uint32_t triangle[kPerLeaf]; // id; kNoItem: no triangle, or one that no ray can hit
};

/// Triangles in world space.
struct WorldTriangles {
    std::span<const glm::vec3> position; // (V)
    std::span<const glm::uvec3> index;   // (T)
};

/// The hierarchy. Built and refitted by one thread; read by any number.
class RayTree {
  public:
    /// Builds the topology and fits it. limits  2^31 - 1 triangles
    void build(const WorldTriangles& triangles, Tasks& tasks);

    /// Fits boxes and corners to other positions of the triangles that it was built of. Where the boxes have
    /// grown so much that rays would meet twice as many, it builds anew. returns  whether it did
    bool refit(const WorldTriangles& triangles, Tasks& tasks);

    bool empty() const { return node_.empty(); }
    std::span<const TreeNode> nodes() const
    {
        return node_;
    } // children after their parents, the root first
    std::span<const TriangleBlock> blocks() const { return block_; }
    float largest_coordinate() const { return largest_; } // absolute, of all triangles in it

    /// How often trees were built and refitted in this process, to see that frames do neither.
    struct Counts {
        std::uint64_t builds, refits;
    };
    static Counts counts();

  private:
    void fit(const WorldTriangles& triangles, Tasks& tasks);
    double cost() const;

    std::vector<TreeNode> node_;
    std::vector<TriangleBlock> block_;
    std::vector<std::uint32_t>
        order_; // (blocks * kPerLeaf) ids of triangles, kNoItem where there is none
    std::vector<std::array<glm::vec3, 2>> leaf_box_; // (blocks)
    float largest_ = 0;
    double built_cost_ = 0; // when the topology was new
};

} // namespace firsthit
