// point_tree.h - finds those of many points of a plane that lie near a triangle.
#pragma once

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace firsthit {

/// A kd-tree over points, halved at the median of the longer side until few are left.
///
/// source  Bentley 1975, "Multidimensional Binary Search Trees Used for Associative Searching"
class PointTree {
  public:
    /// point   coordinates, finite; kept by reference
    /// chosen  which of them are in the tree
    PointTree(std::span<const glm::dvec2> point, std::vector<std::uint32_t> chosen);

    /// Calls found(number) for every point in the triangle, its border included, and for some near it,
    /// until found says true.
    ///
    /// triangle  counter-clockwise
    /// work      counts one more for each part of the tree and each point that is looked at
    /// returns   whether found said true
    template <class Found>
    bool any_near(
        const std::array<glm::dvec2, 3>& triangle, std::size_t& work, const Found& found) const
    {
        return !chosen_.empty() &&
               search({.first = 0, .end = chosen_.size(), .box = 1}, triangle, work, found);
    }

  private:
    static constexpr std::size_t kLeaf = 8; // points: as quick to look at as the boxes of halves

    struct Box {
        glm::dvec2 low{0};
        glm::dvec2 high{0};
    };
    /// chosen_[first, end), whose box is boxes_[box]; its halves' boxes are 2 box and 2 box + 1.
    struct Part {
        std::size_t first;
        std::size_t end;
        std::size_t box;

        bool is_leaf() const { return end - first <= kLeaf; }
        Part lower() const { return {first, (first + end) / 2, 2 * box}; }
        Part upper() const { return {(first + end) / 2, end, 2 * box + 1}; }
    };

    void build(const Part& part);
    static bool is_apart(const Box& box, const std::array<glm::dvec2, 3>& triangle);

    template <class Found>
    bool search(const Part& part, const std::array<glm::dvec2, 3>& triangle, std::size_t& work,
        const Found& found) const
    {
        ++work;
        if (is_apart(boxes_[part.box], triangle)) return false;
        if (!part.is_leaf())
            return search(part.lower(), triangle, work, found) ||
                   search(part.upper(), triangle, work, found);
        work += part.end - part.first;
        for (std::size_t k = part.first; k < part.end; ++k)
            if (found(chosen_[k])) return true;
        return false;
    }

    std::span<const glm::dvec2> point_;
    std::vector<std::uint32_t> chosen_;
    std::vector<Box> boxes_; // by number of the part, from 1
};

} // namespace firsthit
