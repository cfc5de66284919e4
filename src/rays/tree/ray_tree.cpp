// ray_tree.cpp - fits the boxes and corners of a RayTree to positions.
#include "rays/tree/ray_tree.h"

#include "base/large_pages.h"
#include "exact/hit.h"
#include "rays/tree/build_tree.h"

#include <firsthit/scene.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace firsthit {
namespace {

using glm::vec3;
using TreeBounds = std::array<vec3, 2>;

constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr std::size_t kBlocksATask = 512;
/// A tree whose cost has grown by this factor is built anew.
constexpr double kWorn = 2;

std::atomic<std::uint64_t> all_builds{0}, all_refits{0};

/// Whether a ray can hit the triangle, as far as a look at the corners tells.
bool can_be_hit(const Corners& c)
{
    return usable(c) && c[0] != c[1] && c[1] != c[2] && c[2] != c[0];
}

/// Fills in a block. returns  the box of its triangles; an empty one where it has none
TreeBounds fit_block(
    const WorldTriangles& triangles, const std::uint32_t* order, TriangleBlock& block)
{
    TreeBounds box{vec3(kInfinite), vec3(-kInfinite)};
    for (int k = 0; k < kPerLeaf; ++k) {
        Corners corners{};
        block.triangle[k] = kNoItem;
        if (order[k] != kNoItem) {
            const glm::uvec3& c = triangles.index[order[k]];
            const Corners given{
                triangles.position[c.x], triangles.position[c.y], triangles.position[c.z]};
            if (can_be_hit(given)) {
                corners = given;
                block.triangle[k] = order[k];
                for (const vec3& p : given) {
                    box[0] = glm::min(box[0], p);
                    box[1] = glm::max(box[1], p);
                }
            }
        }
        for (int corner = 0; corner < 3; ++corner)
            for (int axis = 0; axis < 3; ++axis)
                block.corner[3 * corner + axis][k] = corners[std::size_t(corner)][axis];
    }
    return box;
}

double half_area(const TreeBounds& box)
{
    const glm::dvec3 size = glm::dvec3(box[1]) - glm::dvec3(box[0]);
    return size.x >= 0 ? size.x * size.y + size.y * size.z + size.z * size.x : 0;
}

TreeBounds bounds_of(const TreeNode& node, int child)
{
    const auto corner = [&](int first) {
        return vec3(
            node.bound[first][child], node.bound[first + 1][child], node.bound[first + 2][child]);
    };
    return {corner(0), corner(3)};
}

TreeBounds bounds_of(const TreeNode& node)
{
    TreeBounds all{vec3(kInfinite), vec3(-kInfinite)};
    for (int child = 0; child < kWide; ++child) {
        const TreeBounds box = bounds_of(node, child);
        all = {glm::min(all[0], box[0]), glm::max(all[1], box[1])};
    }
    return all;
}

} // namespace

void RayTree::build(const WorldTriangles& triangles, Tasks& tasks)
{
    ++all_builds;
    TreeTopology topology = build_topology(triangles);
    resize_in_large_pages(node_, topology.node.size());
    std::copy(topology.node.begin(), topology.node.end(), node_.begin());
    order_ = std::move(topology.order);
    resize_in_large_pages(block_, order_.size() / kPerLeaf);
    leaf_box_.resize(block_.size());
    fit(triangles, tasks);
    built_cost_ = cost();
}

bool RayTree::refit(const WorldTriangles& triangles, Tasks& tasks)
{
    ++all_refits;
    fit(triangles, tasks);
    const bool is_worn = cost() > kWorn * built_cost_;
    if (is_worn) build(triangles, tasks);
    return is_worn;
}

RayTree::Counts RayTree::counts()
{
    return {all_builds, all_refits};
}

void RayTree::fit(const WorldTriangles& triangles, Tasks& tasks)
{
    tasks.for_ranges(block_.size(), kBlocksATask, [&](std::size_t first, std::size_t last) {
        for (std::size_t b = first; b < last; ++b)
            leaf_box_[b] = fit_block(triangles, order_.data() + b * kPerLeaf, block_[b]);
    });
    for (std::size_t n = node_.size(); n-- > 0;) {
        TreeNode& node = node_[n];
        for (int k = 0; k < kWide; ++k) {
            const TreeChild child = node.child[k];
            TreeBounds box{vec3(kInfinite), vec3(-kInfinite)};
            if (child.value != TreeChild::kNone)
                box = child.is_leaf() ? leaf_box_[child.index()] : bounds_of(node_[child.index()]);
            for (int axis = 0; axis < 3; ++axis) {
                node.bound[axis][k] = box[0][axis];
                node.bound[3 + axis][k] = box[1][axis];
            }
        }
    }
    largest_ = 0;
    if (node_.empty()) return;
    const TreeBounds all = bounds_of(node_[0]);
    for (const vec3& p : all)
        for (int axis = 0; axis < 3; ++axis)
            if (std::isfinite(p[axis])) largest_ = std::max(largest_, std::abs(p[axis]));
}

/// The expected number of boxes that a ray through the root meets.
double RayTree::cost() const
{
    if (node_.empty()) return 0;
    double sum = 0;
    for (const TreeNode& node : node_)
        for (int k = 0; k < kWide; ++k) sum += half_area(bounds_of(node, k));
    const double root = half_area(bounds_of(node_[0]));
    return root > 0 ? sum / root : 0;
}

} // namespace firsthit
