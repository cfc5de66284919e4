// build_tree.h - the topology of a RayTree, by the surface area heuristic.
#pragma once

#include "rays/tree/ray_tree.h"

#include <cstdint>
#include <vector>

namespace firsthit {

/// Which triangles are in which leaf, and which children a node has. The boxes of nodes are not filled in.
struct TreeTopology {
    std::vector<TreeNode> node;       // children after their parents
    std::vector<std::uint32_t> order; // kPerLeaf ids for each block, kNoItem where there is none
};

/// All triangles are in it, also those that no ray can hit at these positions.
TreeTopology build_topology(const WorldTriangles& triangles);

} // namespace firsthit
